//! Reads a USB capture as another program would: from the descriptions of the
//! file alone, and with suspicion.
//!
//! pcap with `LINKTYPE_USB_LINUX_MMAPPED` (220): the kernel's
//! `Documentation/usb/usbmon.rst`, structure `usbmon_packet`.

/// Bytes of the file's and of a packet's own header, and of usbmon's.
const FILE_HEADER: usize = 24;
const PACKET_HEADER: usize = 16;
const USBMON_HEADER: usize = 64;

/// One packet: a transfer submitted or completed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packet {
    /// Fields that submission and completion share.
    pub id: u64,
    /// `S` for a submission, `C` for a completion.
    pub kind: u8,
    /// 2 for control, 3 for bulk.
    pub transfer: u8,
    /// Endpoint with its direction in bit 7.
    pub endpoint: u8,
    /// Address of the device.
    pub device: u8,
    /// 0 for success, -32 for a stall.
    pub status: i32,
    /// Setup packet of a control transfer's submission.
    pub setup: Option<[u8; 8]>,
    /// Data that go with it.
    pub data: Vec<u8>,
    /// Microseconds since the beginning of time.
    pub at_us: u64,
}

/// Reads a whole capture.
///
/// # Errors
/// Defect, and the byte it is at.
pub fn read(file: &[u8]) -> Result<Vec<Packet>, String> {
    let header = file.get(..FILE_HEADER).ok_or("no file header")?;
    if header[..8] != [0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0] || header[20..] != [220, 0, 0, 0] {
        return Err("no little-endian pcap 2.4 of link type 220".into());
    }
    let mut packets: Vec<Packet> = Vec::new();
    let mut at = FILE_HEADER;
    while at < file.len() {
        let (packet, length) =
            packet(&file[at..]).map_err(|error| format!("byte {at}: {error}"))?;
        check_order(&packets, &packet).map_err(|error| format!("byte {at}: {error}"))?;
        packets.push(packet);
        at += length;
    }
    match packets.last() {
        Some(last) if last.kind == b'S' => Err("a transfer without an end".into()),
        _ => Ok(packets),
    }
}

/// Time goes on, and every completion follows its submission.
fn check_order(before: &[Packet], packet: &Packet) -> Result<(), String> {
    let last = before.last();
    if last.is_some_and(|last| last.at_us > packet.at_us) {
        return Err("time runs backwards".into());
    }
    let open = last.filter(|last| last.kind == b'S');
    let same = |open: &Packet| {
        (open.id, open.transfer, open.endpoint, open.device)
            == (packet.id, packet.transfer, packet.endpoint, packet.device)
    };
    match (packet.kind, open) {
        (b'S', None) => Ok(()),
        (b'C', Some(open)) if same(open) => Ok(()),
        _ => Err("submissions and completions do not alternate".into()),
    }
}

fn packet(bytes: &[u8]) -> Result<(Packet, usize), String> {
    let word = |at: usize| -> Result<u32, String> {
        let word = bytes.get(at..at + 4).ok_or("cut short")?;
        Ok(u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
    };
    let (captured, original) = (word(8)? as usize, word(12)? as usize);
    let end = PACKET_HEADER + captured;
    let usbmon = bytes.get(PACKET_HEADER..end).ok_or("cut short")?;
    let data = usbmon.get(USBMON_HEADER..).ok_or("no usbmon header")?;
    let at = |offset: usize| PACKET_HEADER + offset;
    if captured != original || word(at(36))? as usize != data.len() {
        return Err("lengths that contradict each other".into());
    }
    let seconds = u64::from(word(at(16))?) | u64::from(word(at(20))?) << 32;
    if seconds != u64::from(word(0)?) || word(at(24))? != word(4)? {
        return Err("two times".into());
    }
    let setup = (usbmon[14] == 0).then(|| usbmon[40..48].try_into().expect("eight bytes"));
    let packet = Packet {
        id: u64::from(word(at(0))?) | u64::from(word(at(4))?) << 32,
        kind: usbmon[8],
        transfer: usbmon[9],
        endpoint: usbmon[10],
        device: usbmon[11],
        status: word(at(28))? as i32,
        setup,
        data: data.to_vec(),
        at_us: seconds * 1_000_000 + u64::from(word(4)?),
    };
    Ok((packet, end))
}
