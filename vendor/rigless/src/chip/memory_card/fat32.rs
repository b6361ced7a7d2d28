// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The empty FAT32 volume `FatFs` R0.14b's `f_mkfs` writes, sector by sector, for a single-partition card
//! with a 512-byte sector: the same fields at the same offsets, named as `ff.c` names them, so the reader
//! on the part meets what its own formatter would have left.

use crate::chip::sd::BLOCK;

/// `ff.c`: the offsets of the boot sector's fields, `BS_` and `BPB_`, and of the FSINFO sector's,
/// `FSI_`.
const BS_JMP_BOOT: usize = 0;
const BPB_BYTS_PER_SEC: usize = 11;
const BPB_SEC_PER_CLUS: usize = 13;
const BPB_RSVD_SEC_CNT: usize = 14;
const BPB_NUM_FATS: usize = 16;
const BPB_MEDIA: usize = 21;
const BPB_SEC_PER_TRK: usize = 24;
const BPB_NUM_HEADS: usize = 26;
const BPB_TOT_SEC32: usize = 32;
const BPB_FAT_SZ32: usize = 36;
const BPB_ROOT_CLUS32: usize = 44;
const BPB_FS_INFO32: usize = 48;
const BPB_BK_BOOT_SEC32: usize = 50;
const BS_DRV_NUM32: usize = 64;
const BS_BOOT_SIG32: usize = 66;
const BS_VOL_ID32: usize = 67;
const BS_VOL_LAB32: usize = 71;
const BS_55AA: usize = 510;
const FSI_LEAD_SIG: usize = 0;
const FSI_STRUC_SIG: usize = 484;
const FSI_FREE_COUNT: usize = 488;
const FSI_NXT_FREE: usize = 492;

/// `f_mkfs`: what it writes into those fields for a FAT32 volume.
const JUMP_AND_OEM: &[u8; 11] = b"\xEB\xFE\x90MSDOS5.0";
const RESERVED_SECTORS: u16 = 32;
const FATS: u8 = 2;
const MEDIA: u8 = 0xF8;
const SECTORS_PER_TRACK: u16 = 63;
const HEADS: u16 = 255;
const ROOT_CLUSTER: u32 = 2;
const FSINFO_SECTOR: u16 = 1;
const BACKUP_BOOT_SECTOR: u16 = 6;
const BACKUP_FSINFO_SECTOR: usize = 7;
const DRIVE_NUMBER: u8 = 0x80;
const EXTENDED_BOOT_SIGNATURE: u8 = 0x29;
const LABEL_AND_TYPE: &[u8; 19] = b"NO NAME    FAT32   ";
const SIGNATURE: u16 = 0xAA55;
const FSI_LEAD: u32 = 0x4161_5252;
const FSI_STRUC: u32 = 0x6141_7272;
const FAT_0: u32 = 0xFFFF_FFF8;
const FAT_1: u32 = 0xFFFF_FFFF;
const FAT_ROOT: u32 = 0x0FFF_FFFF;
/// `f_mkfs`'s largest cluster, 64 sectors, which its table picks for any volume of 4 GiB or more.
const SECTORS_PER_CLUSTER: u8 = 64;
/// `ff.c`'s `MAX_FAT16`: a FAT32 volume has more clusters than this.
const MIN_FAT32_CLUSTERS: usize = 0xFFF5;
/// The volume serial number, which `f_mkfs` takes from the clock and this takes once.
const VOLUME_SERIAL: u32 = 0x5249_474C;

/// The sectors that differ from zero in a fresh volume of `sectors` sectors, by index.
///
/// # Panics
///
/// Panics on a volume with too few clusters to be FAT32.
pub(super) fn volume(sectors: usize) -> Vec<(usize, [u8; BLOCK])> {
    let per_cluster = usize::from(SECTORS_PER_CLUSTER);
    let clusters_at_most = sectors / per_cluster;
    let fat_sectors = (clusters_at_most * 4 + 8).div_ceil(BLOCK);
    let reserved = usize::from(RESERVED_SECTORS);
    let data = reserved + usize::from(FATS) * fat_sectors;
    let clusters = (sectors - data) / per_cluster;
    assert!(clusters > MIN_FAT32_CLUSTERS, "too few clusters for FAT32");

    let mut boot = [0; BLOCK];
    boot[..JUMP_AND_OEM.len()].copy_from_slice(JUMP_AND_OEM);
    word(
        &mut boot,
        BPB_BYTS_PER_SEC,
        u16::try_from(BLOCK).expect("a sector's size"),
    );
    boot[BPB_SEC_PER_CLUS] = SECTORS_PER_CLUSTER;
    word(&mut boot, BPB_RSVD_SEC_CNT, RESERVED_SECTORS);
    boot[BPB_NUM_FATS] = FATS;
    dword(&mut boot, BPB_TOT_SEC32, sector_count(sectors));
    boot[BPB_MEDIA] = MEDIA;
    word(&mut boot, BPB_SEC_PER_TRK, SECTORS_PER_TRACK);
    word(&mut boot, BPB_NUM_HEADS, HEADS);
    dword(&mut boot, BS_VOL_ID32, VOLUME_SERIAL);
    dword(&mut boot, BPB_FAT_SZ32, sector_count(fat_sectors));
    dword(&mut boot, BPB_ROOT_CLUS32, ROOT_CLUSTER);
    word(&mut boot, BPB_FS_INFO32, FSINFO_SECTOR);
    word(&mut boot, BPB_BK_BOOT_SEC32, BACKUP_BOOT_SECTOR);
    boot[BS_DRV_NUM32] = DRIVE_NUMBER;
    boot[BS_BOOT_SIG32] = EXTENDED_BOOT_SIGNATURE;
    boot[BS_VOL_LAB32..BS_VOL_LAB32 + LABEL_AND_TYPE.len()].copy_from_slice(LABEL_AND_TYPE);
    word(&mut boot, BS_55AA, SIGNATURE);

    let mut info = [0; BLOCK];
    dword(&mut info, FSI_LEAD_SIG, FSI_LEAD);
    dword(&mut info, FSI_STRUC_SIG, FSI_STRUC);
    dword(&mut info, FSI_FREE_COUNT, sector_count(clusters - 1));
    dword(&mut info, FSI_NXT_FREE, ROOT_CLUSTER);
    word(&mut info, BS_55AA, SIGNATURE);

    let mut fat = [0; BLOCK];
    dword(&mut fat, 0, FAT_0);
    dword(&mut fat, 4, FAT_1);
    dword(&mut fat, 8, FAT_ROOT);

    vec![
        (BS_JMP_BOOT, boot),
        (usize::from(BACKUP_BOOT_SECTOR), boot),
        (usize::from(FSINFO_SECTOR), info),
        (BACKUP_FSINFO_SECTOR, info),
        (reserved, fat),
        (reserved + fat_sectors, fat),
    ]
}

fn sector_count(count: usize) -> u32 {
    u32::try_from(count).expect("a FAT32 volume counts in thirty-two bits")
}

fn word(sector: &mut [u8; BLOCK], at: usize, value: u16) {
    sector[at..at + 2].copy_from_slice(&value.to_le_bytes());
}

fn dword(sector: &mut [u8; BLOCK], at: usize, value: u32) {
    sector[at..at + 4].copy_from_slice(&value.to_le_bytes());
}
