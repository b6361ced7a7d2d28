//! Offsets and bits of the core (RM0433 Rev 9, section 57.14).

pub(super) const GOTGCTL: u64 = 0x000;
pub(super) const GOTGINT: u64 = 0x004;
pub(super) const GAHBCFG: u64 = 0x008;
pub(super) const GUSBCFG: u64 = 0x00C;
pub(super) const GRSTCTL: u64 = 0x010;
pub(super) const GINTSTS: u64 = 0x014;
pub(super) const GINTMSK: u64 = 0x018;
pub(super) const GRXSTSR: u64 = 0x01C;
pub(super) const GRXSTSP: u64 = 0x020;
pub(super) const GRXFSIZ: u64 = 0x024;
pub(super) const DIEPTXF0: u64 = 0x028;
pub(super) const GCCFG: u64 = 0x038;
pub(super) const CID: u64 = 0x03C;
pub(super) const DIEPTXF1: u64 = 0x104;
pub(super) const DIEPTXF8: u64 = 0x120;
pub(super) const DCFG: u64 = 0x800;
pub(super) const DCTL: u64 = 0x804;
pub(super) const DSTS: u64 = 0x808;
pub(super) const DIEPMSK: u64 = 0x810;
pub(super) const DOEPMSK: u64 = 0x814;
pub(super) const DAINT: u64 = 0x818;
pub(super) const DAINTMSK: u64 = 0x81C;
pub(super) const DIEPEMPMSK: u64 = 0x834;
pub(super) const IN_ENDPOINTS: u64 = 0x900;
pub(super) const OUT_ENDPOINTS: u64 = 0xB00;
pub(super) const ENDPOINT_STRIDE: u64 = 0x20;
pub(super) const PCGCCTL: u64 = 0xE00;
pub(super) const FIFOS: u64 = 0x1000;
pub(super) const FIFO_STRIDE: u64 = 0x1000;

/// Endpoints in each direction.
pub(super) const ENDPOINTS: usize = 9;

/// Offsets within an endpoint's block.
pub(super) const EP_CONTROL: u64 = 0x00;
pub(super) const EP_INTERRUPT: u64 = 0x08;
pub(super) const EP_SIZE: u64 = 0x10;
pub(super) const EP_FIFO_STATUS: u64 = 0x18;

/// Value of `CID` on this part.
pub(super) const CORE_ID: u32 = 0x0000_2300;

/// `GOTGCTL`: B-session valid.
pub(super) const BSVLD: u32 = 1 << 19;
/// `GOTGINT`: session end detected.
pub(super) const SEDET: u32 = 1 << 2;
/// `GAHBCFG`: interrupts reach the core.
pub(super) const GINT: u32 = 1;

/// `GRSTCTL`.
pub(super) const CSRST: u32 = 1;
pub(super) const RXFFLSH: u32 = 1 << 4;
pub(super) const TXFFLSH: u32 = 1 << 5;
pub(super) const AHBIDL: u32 = 1 << 31;
/// `TXFNUM` of all FIFOs.
pub(super) const ALL_FIFOS: u32 = 0x10;

/// `GINTSTS` and `GINTMSK`.
pub(super) const OTGINT: u32 = 1 << 2;
pub(super) const RXFLVL: u32 = 1 << 4;
pub(super) const NPTXFE: u32 = 1 << 5;
pub(super) const USBSUSP: u32 = 1 << 11;
pub(super) const USBRST: u32 = 1 << 12;
pub(super) const ENUMDNE: u32 = 1 << 13;
pub(super) const IEPINT: u32 = 1 << 18;
pub(super) const OEPINT: u32 = 1 << 19;
pub(super) const SRQINT: u32 = 1 << 30;
pub(super) const WKUPINT: u32 = 1 << 31;

/// `GCCFG`: the transceiver is on.
pub(super) const PWRDWN: u32 = 1 << 16;
/// `DCTL`: remote wake-up, soft disconnect.
pub(super) const RWUSIG: u32 = 1;
pub(super) const SDIS: u32 = 1 << 1;
/// `DSTS`: suspended; full speed on the internal transceiver.
pub(super) const SUSPSTS: u32 = 1;
pub(super) const FULL_SPEED: u32 = 0b11 << 1;

/// `DIEPCTL` and `DOEPCTL`.
pub(super) const USBAEP: u32 = 1 << 15;
pub(super) const DPID: u32 = 1 << 16;
pub(super) const NAKSTS: u32 = 1 << 17;
pub(super) const STALL: u32 = 1 << 21;
pub(super) const CNAK: u32 = 1 << 26;
pub(super) const SNAK: u32 = 1 << 27;
pub(super) const SD0PID: u32 = 1 << 28;
pub(super) const SD1PID: u32 = 1 << 29;
pub(super) const EPDIS: u32 = 1 << 30;
pub(super) const EPENA: u32 = 1 << 31;
/// Bits the register stores: packet size, activity, type, stall and FIFO number.
pub(super) const STORED: u32 = 0x7FF | USBAEP | 0b11 << 18 | STALL | 0xF << 22;

/// `DIEPINT` and `DOEPINT`.
pub(super) const XFRC: u32 = 1;
pub(super) const EPDISD: u32 = 1 << 1;
pub(super) const STUP: u32 = 1 << 3;
pub(super) const TXFE: u32 = 1 << 7;

/// `PKTSTS` of the receive status.
pub(super) const OUT_DATA: u32 = 2;
pub(super) const OUT_DONE: u32 = 3;
pub(super) const SETUP_DONE: u32 = 4;
pub(super) const SETUP_DATA: u32 = 6;
