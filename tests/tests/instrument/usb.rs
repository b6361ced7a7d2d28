//! The shipping firmware over USB: set up by a host, used by the host tool,
//! disturbed in every way a cable and a host can.

use calib_core::point::ExcitationKind;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::Client;
use calib_link::Error;
use calib_link::session;
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Refusal, Request, Response, RunSpec};
use calib_protocol::record::RunLabels;
use calib_tests::capture::{self, Packet};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::usb::{Setup, UsbError};
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::SharedEmulator;
use calib_twin::usb_host::{self, HostError, UsbHost};
use std::ffi::OsStr;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// Longest time to an answer, whatever went before.
const PROMPT: Duration = Duration::from_millis(100);

/// The address the emulated host gives the device.
const ADDRESS: u8 = 7;

/// Number of the first request over USB, away from those over the serial line.
const FIRST_REQUEST: u16 = 0x2000;

/// Plugs in and opens a client over USB.
fn plug_in(board: &SharedEmulator) -> Result<Client, Fault> {
    let usb = EmulatedUsbTransport::plug_in(board.clone())?;
    Ok(Client::new(Box::new(usb)).counting_from(FIRST_REQUEST))
}

/// Fails unless `client` is answered in time.
fn expect_answer(board: &SharedEmulator, client: &mut Client) -> Result<(), Fault> {
    let elapsed = || {
        board
            .lock()
            .map(|board| board.elapsed())
            .unwrap_or_default()
    };
    let before = elapsed();
    client.info()?;
    let took = elapsed() - before;
    assert!(took <= PROMPT, "{took:?}");
    Ok(())
}

#[test]
fn a_record_comes_over_usb_as_over_the_serial_line() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.board().usb().start_capture();
    let usb = EmulatedUsbTransport::plug_in(rigged.shared())?;
    let names = usb.device().names.clone();
    let mut client = Client::new(Box::new(usb)).counting_from(FIRST_REQUEST);
    let serial = client.info()?.serial.to_string();
    assert_eq!(names, ["calib", "Field vibration calibrator", &serial]);

    let points = [point(160.0, 10.0), point(1000.0, 10.0)];
    let outcome = session::run(&mut client, &points, RunLabels::default(), |_| {
        ControlFlow::Continue(())
    })?;
    let folder = tempfile::tempdir()?;
    let (over_usb, over_serial) = (folder.path().join("usb"), folder.path().join("serial"));
    let over_usb = session::download(&mut client, outcome.record_id, &over_usb, |_| ())?;
    let over_serial =
        session::download(&mut rigged.client, outcome.record_id, &over_serial, |_| ())?;
    let record = std::fs::read(over_usb.path)?;
    assert_eq!(record, std::fs::read(over_serial.path)?);
    assert_eq!(client.repetitions(), 0, "nothing had to be asked twice");

    // Lengths one apart, so that one answer fills its last packet.
    for offset in (record.len() - 70..).take(64) {
        client.read_record(outcome.record_id, offset as u32)?;
    }
    let file = folder.path().join("usb.pcap");
    let transfers = rigged.board().usb().transferred();
    usb_host::capture::write(&transfers, &mut std::fs::File::create(&file)?)?;
    let packets = capture::read(&std::fs::read(&file)?)?;
    check_enumeration(&packets);
    let answers = answers(&packets);
    let held = record_in(&answers);
    assert_eq!(held[..record.len()], record, "the capture holds the record");
    check_packets(&packets, &answers);
    ask_tshark(&file, packets.len(), &serial)?;
    let unused = rigged.unused_stack_bytes()?;
    assert!(unused >= 8 << 10, "less than 8 KiB are left");
    Ok(())
}

/// The requests every operating system begins with, in their order.
fn check_enumeration(packets: &[Packet]) {
    let setups: Vec<(u8, [u8; 8])> = packets
        .iter()
        .filter_map(|packet| Some((packet.device, packet.setup?)))
        .collect();
    // Get descriptor (device, 8 bytes) at address 0; set address 7.
    assert_eq!(setups[0], (0, [0x80, 6, 0, 1, 0, 0, 8, 0]));
    assert_eq!(setups[1], (0, [0x00, 5, 7, 0, 0, 0, 0, 0]));
    // Set configuration 1, line coding, control line state: DTR and RTS.
    let last: Vec<[u8; 8]> = setups[setups.len() - 3..].iter().map(|s| s.1).collect();
    assert_eq!(
        last,
        [
            [0x00, 9, 1, 0, 0, 0, 0, 0],
            [0x21, 0x20, 0, 0, 0, 0, 7, 0],
            [0x21, 0x22, 3, 0, 0, 0, 0, 0],
        ]
    );
    let coding = packets.iter().find(|packet| {
        let setup = packet.setup.unwrap_or_default();
        setup[..2] == [0x21, 0x20]
    });
    // 115 200 baud, one stop bit, no parity, eight bits (PSTN 1.2, table 17).
    let coding = coding.expect("line coding").data.clone();
    assert_eq!(coding, [0x00, 0xC2, 0x01, 0x00, 0, 0, 8]);
}

/// The frames the device sent, with terminators.
fn answers(packets: &[Packet]) -> Vec<Vec<u8>> {
    let bytes: Vec<u8> = from_device(packets)
        .flat_map(|packet| packet.data.clone())
        .collect();
    bytes
        .split_inclusive(|byte| *byte == 0)
        .map(<[u8]>::to_vec)
        .collect()
}

fn from_device(packets: &[Packet]) -> impl Iterator<Item = &Packet> {
    let bulk = packets.iter().filter(|packet| packet.transfer == 3);
    bulk.filter(|packet| packet.kind == b'C' && packet.endpoint & 0x80 != 0)
}

/// Puts the record together from the answers that hold parts of it.
fn record_in(answers: &[Vec<u8>]) -> Vec<u8> {
    let mut record = Vec::new();
    for answer in answers {
        let mut raw = answer[..answer.len() - 1].to_vec();
        let frame = Frame::check(&mut raw).expect("whole");
        if let Ok(Response::RecordData { data, .. }) = frame.message() {
            record.extend(data);
        }
    }
    record
}

/// An answer is sent in packets of 64 bytes and ends with a shorter one, which
/// is empty when nothing is left (USB 2.0, 5.8.3).
fn check_packets(packets: &[Packet], answers: &[Vec<u8>]) {
    let found: Vec<usize> = from_device(packets)
        .map(|packet| packet.data.len())
        .collect();
    let expected: Vec<usize> = answers
        .iter()
        .flat_map(|answer| {
            let full = answer.len() / 64;
            std::iter::repeat_n(64, full).chain([answer.len() % 64])
        })
        .collect();
    assert_eq!(found, expected);
    assert!(
        found.contains(&0),
        "one of 64 lengths in a row is a multiple of 64"
    );
}

/// Who the device says it is, as Wireshark prints the fields of its descriptor
/// (USB 2.0, table 9-8).
const DESCRIPTOR: [(&str, &str); 9] = [
    ("usb.bLength", "18"),
    ("usb.bcdUSB", "0x0210"),
    ("usb.bDeviceClass", "0xef"),
    ("usb.bDeviceSubClass", "2"),
    ("usb.bDeviceProtocol", "1"),
    ("usb.bMaxPacketSize0", "64"),
    ("usb.idVendor", "0x1209"),
    ("usb.idProduct", "0x0001"),
    ("usb.bNumConfigurations", "1"),
];

/// Wireshark's word on the capture, where it is installed: in CI it must be.
fn ask_tshark(file: &Path, packets: usize, serial: &str) -> Result<(), Fault> {
    let named = std::env::var_os("CALIB_TSHARK");
    let fields = ["frame.protocols", "_ws.malformed", "_ws.expert"];
    let Some(text) = tshark(named.as_deref(), file, "usb", &fields)? else {
        assert!(std::env::var_os("CI").is_none(), "tshark is missing");
        println!("tshark is not installed: the capture was read by this test's own reader alone");
        return Ok(());
    };
    assert_eq!(text.lines().count(), packets, "every packet is USB");
    for line in text.lines() {
        let columns: Vec<&str> = line.split('\t').collect();
        assert!(columns[0].starts_with("usb"), "{line}");
        assert_eq!(columns[1..], ["", ""], "malformed, or doubtful: {line}");
    }
    // The whole descriptor: the eight bytes asked for first have no vendor.
    let (names, values): (Vec<_>, Vec<_>) = DESCRIPTOR.into_iter().unzip();
    let found = tshark(
        named.as_deref(),
        file,
        "usb.idVendor && usb.bcdDevice",
        &names,
    )?;
    assert_eq!(found.unwrap_or_default().trim_end(), values.join("\t"));
    let strings = tshark(named.as_deref(), file, "usb.bString", &["usb.bString"])?;
    let strings = strings.unwrap_or_default();
    let expected = ["calib", "Field vibration calibrator", serial];
    assert_eq!(strings.lines().collect::<Vec<_>>(), expected);
    Ok(())
}

/// Fields tshark prints of the packets it shows; nothing when it is not there.
fn tshark(
    named: Option<&OsStr>,
    file: &Path,
    shown: &str,
    fields: &[&str],
) -> Result<Option<String>, Fault> {
    let mut tshark = Command::new(named.unwrap_or(OsStr::new("tshark")));
    tshark
        .arg("-r")
        .arg(file)
        .args(["-Y", shown, "-T", "fields"]);
    tshark.args(fields.iter().flat_map(|field| ["-e", field]));
    let Ok(output) = tshark.output() else {
        return Ok(None);
    };
    assert!(output.status.success(), "{output:?}");
    Ok(Some(String::from_utf8(output.stdout)?))
}

/// Sets the device up and asks it for a long answer.
fn use_once(board: &SharedEmulator) -> Result<(), Fault> {
    plug_in(board)?.settings()?;
    Ok(())
}

#[test]
fn a_cable_pulled_after_any_packet_harms_nothing() -> Result<(), Fault> {
    // A control transfer takes three to five transactions: none is left out.
    const STRIDE: usize = 3;
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    let board = rigged.shared();
    for transactions in (0..).step_by(STRIDE) {
        rigged.board().usb().pull_after(transactions);
        let used = use_once(&board);
        expect_answer(&board, &mut rigged.client)?;
        if rigged.board().usb().is_plugged() {
            // Eleven control transfers of two transactions at least, 22 packets of answer.
            assert!(transactions > 40, "{transactions}: {used:?}");
            return used;
        }
        used.expect_err("the cable is out");
    }
    Ok(())
}

#[test]
fn a_usb_host_may_do_what_it_likes() -> Result<(), Fault> {
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    let board = rigged.shared();
    let port = rigged.board().usb().clone();
    let mut client = plug_in(&board)?;
    let settings = rigged.client.settings()?;

    // It asks for what there is not.
    let host = UsbHost::new(board.clone());
    for (request_type, request, value) in [(0x80, 6, 0x5500), (0x80, 6, 0x0309), (0x00, 9, 7)] {
        let setup = Setup {
            request_type,
            request,
            value,
            index: 0,
            length: if request_type == 0x80 { 64 } else { 0 },
        };
        match host.control("something else", ADDRESS, setup, &[]) {
            Err(HostError::Transfer { error, .. }) => assert_eq!(error, UsbError::Stall),
            other => return Err(format!("{setup:?}: {other:?}").into()),
        }
    }
    expect_answer(&board, &mut client)?;

    // It loses every third handshake: every packet arrives, and once.
    port.lose_handshakes(3);
    assert_eq!(client.settings()?, settings);
    assert_eq!(client.repetitions(), 0);
    port.lose_handshakes(0);

    // It falls asleep in the middle of an answer, and wakes up.
    port.send(&frame(1, &Request::SettingsRead));
    host.wait(Duration::from_millis(1))?;
    port.suspend(true);
    host.wait(Duration::from_millis(500))?;
    expect_answer(&board, &mut rigged.client)?;
    port.suspend(false);
    host.wait(Duration::from_millis(20))?;
    expect_settings(&port.receive());
    expect_answer(&board, &mut client)?;

    // It resets the bus in the middle of an answer.
    port.send(&frame(2, &Request::SettingsRead));
    host.wait(Duration::from_millis(1))?;
    let device = host.enumerate()?;
    expect_answer(&board, &mut rigged.client)?;
    host.open_serial(&device, 9600)?;
    expect_answer(&board, &mut client)?;

    // It never reads, and goes on asking.
    port.set_reading(false);
    for sequence in 0..20 {
        port.send(&frame(sequence, &Request::SettingsRead));
        host.wait(Duration::from_millis(60))?;
        if sequence % 5 == 0 {
            expect_answer(&board, &mut rigged.client)?;
        }
    }
    port.set_reading(true);
    client.info()?;
    expect_answer(&board, &mut client)?;

    // It resets the board, which takes the device off the bus.
    client.reset()?;
    host.wait(Duration::from_millis(300))?;
    client.info().expect_err("the device has gone");
    let mut client = plug_in(&board)?;
    expect_answer(&board, &mut client)
}

/// Fails unless `bytes` are one answer with settings, whole.
fn expect_settings(bytes: &[u8]) {
    let mut receiver = Receiver::new();
    let mut answers = Vec::new();
    for byte in bytes {
        if let Some(raw) = receiver.push(*byte) {
            let frame = Frame::check(raw).expect("whole");
            answers.push(frame.message::<Response>().expect("an answer"));
        }
    }
    assert!(
        matches!(answers[..], [Response::Settings(_)]),
        "{answers:?}"
    );
}

#[test]
fn one_of_two_hosts_holds_the_session() -> Result<(), Fault> {
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    let board = rigged.shared();
    let mut usb = plug_in(&board)?;
    let mut settings = rigged.client.settings()?;
    // A hand is there all the time: who may is not a matter of the button here.
    rigged.board().press_button(true)?;
    rigged.client.wait(Duration::from_millis(60))?;

    settings.blocks = 11;
    usb.write_settings(settings.clone())?;
    settings.blocks = 12;
    expect_other_host(rigged.client.write_settings(settings.clone()));
    expect_other_host(rigged.client.reset());
    expect_other_host(rigged.client.start(RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    }));
    // The other host may read, and stop what moves.
    rigged.client.stop()?;
    assert_eq!(rigged.client.settings()?.blocks, 11);

    // Who pulls the cable gives the session away.
    rigged.board().usb().plug(false);
    rigged.client.wait(Duration::from_millis(10))?;
    rigged.client.write_settings(settings.clone())?;
    let mut usb = plug_in(&board)?;
    expect_other_host(usb.write_settings(settings.clone()));

    // Who falls silent loses it.
    usb.wait(Duration::from_secs(5))?;
    settings.blocks = 13;
    usb.write_settings(settings)?;
    assert_eq!(rigged.client.settings()?.blocks, 13);
    Ok(())
}

fn expect_other_host<T: std::fmt::Debug>(result: Result<T, Error>) {
    match result {
        Err(Error::Refused(refused)) => assert_eq!(refused.refusal, Refusal::OtherHost),
        other => panic!("{other:?}"),
    }
}

fn frame(sequence: u16, request: &Request) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    let length = encode(sequence, request, &mut buffer).expect("fits");
    buffer.truncate(length);
    buffer
}
