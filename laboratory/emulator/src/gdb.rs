//! A client of GDB's remote protocol (GDB manual, appendix E): only the commands that stop and resume a program and access its memory and registers.

use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::Result;

/// Time after which the other side counts as hanging.
const PATIENCE: Duration = Duration::from_secs(60);
/// Bytes of memory in one request.
const BLOCK: u32 = 1024;

/// A connection to a program in QEMU.
#[derive(Debug)]
pub(crate) struct Gdb {
    input: BufReader<UnixStream>,
    output: UnixStream,
}

impl Gdb {
    /// Connects as soon as the socket is there.
    pub(crate) fn connect(socket: &Path) -> Result<Self> {
        let output = patiently(socket)?;
        output.set_read_timeout(Some(PATIENCE))?;
        let mut gdb = Self { input: BufReader::new(output.try_clone()?), output };
        gdb.ask("QStartNoAckMode")?;
        gdb.output.write_all(b"+")?;
        Ok(gdb)
    }

    pub(crate) fn read(&mut self, address: u32, length: u32) -> Result<Vec<u8>> {
        let mut bytes = Vec::new();
        for start in (0..length).step_by(BLOCK as usize) {
            let block = BLOCK.min(length - start);
            bytes.extend(from_hex(&self.ask(&format!("m{:x},{block:x}", address + start))?)?);
        }
        Ok(bytes)
    }

    pub(crate) fn read_word(&mut self, address: u32) -> Result<u32> {
        let bytes = self.read(address, 4)?;
        Ok(u32::from_le_bytes(bytes.as_slice().try_into()?))
    }

    pub(crate) fn write_word(&mut self, address: u32, value: u32) -> Result<()> {
        self.done(&format!("M{address:x},4:{:08x}", value.swap_bytes()))
    }

    /// A register of the processor: 15 is the program counter.
    pub(crate) fn register(&mut self, number: u32) -> Result<u32> {
        // all registers: QEMU returns single ones only after the client has read its description of the processor
        let bytes = from_hex(&self.ask("g")?)?;
        let bytes = bytes.chunks_exact(4).nth(number as usize).ok_or("no such register")?;
        Ok(u32::from_le_bytes(bytes.try_into()?))
    }

    pub(crate) fn set_breakpoint(&mut self, address: u32) -> Result<()> {
        self.done(&format!("Z0,{address:x},2"))
    }

    pub(crate) fn clear_breakpoint(&mut self, address: u32) -> Result<()> {
        self.done(&format!("z0,{address:x},2"))
    }

    /// Executes one instruction.
    pub(crate) fn step(&mut self) -> Result<()> {
        self.ask("s").map(drop)
    }

    /// Lets the program run.
    pub(crate) fn go(&mut self) -> Result<()> {
        self.send("c")
    }

    /// Waits until the program stops.
    pub(crate) fn wait(&mut self) -> Result<()> {
        let answer = self.receive()?;
        if answer.starts_with('T') { Ok(()) } else { Err(format!("the program ended: {answer}").into()) }
    }

    /// Whether the program runs for this time without stopping.
    pub(crate) fn runs_for(&mut self, time: Duration) -> Result<bool> {
        self.output.set_nonblocking(true)?;
        let end = Instant::now() + time;
        let mut runs = true;
        while runs && Instant::now() < end {
            match self.input.fill_buf() {
                // anything but a packet is an acknowledgement
                Ok(bytes) if bytes.contains(&b'$') => runs = false,
                Ok(bytes) => {
                    let length = bytes.len();
                    self.input.consume(length);
                }
                Err(error) if error.kind() == ErrorKind::WouldBlock => std::thread::sleep(Duration::from_millis(10)),
                Err(error) => return Err(error.into()),
            }
        }
        self.output.set_nonblocking(false)?;
        Ok(runs)
    }

    fn done(&mut self, command: &str) -> Result<()> {
        match self.ask(command)?.as_str() {
            "OK" => Ok(()),
            other => Err(format!("{command} is answered by {other:?}").into()),
        }
    }

    fn ask(&mut self, command: &str) -> Result<String> {
        self.send(command)?;
        self.receive()
    }

    fn send(&mut self, command: &str) -> Result<()> {
        let sum = command.bytes().fold(0_u8, u8::wrapping_add);
        Ok(self.output.write_all(format!("${command}#{sum:02x}").as_bytes())?)
    }

    fn receive(&mut self) -> Result<String> {
        let mut text = Vec::new();
        while self.byte()? != b'$' {}
        loop {
            match self.byte()? {
                b'#' => break,
                byte => text.push(byte),
            }
        }
        // two digits of the checksum, which is not verified
        self.byte()?;
        self.byte()?;
        Ok(String::from_utf8(text)?)
    }

    fn byte(&mut self) -> Result<u8> {
        let mut byte = [0];
        self.input.read_exact(&mut byte)?;
        Ok(byte[0])
    }
}

/// Connects to a socket, and waits until it exists.
pub(crate) fn patiently(socket: &Path) -> Result<UnixStream> {
    let end = Instant::now() + PATIENCE;
    loop {
        match UnixStream::connect(socket) {
            Ok(stream) => return Ok(stream),
            Err(error) if Instant::now() > end => return Err(format!("{}: {error}", socket.display()).into()),
            Err(_) => std::thread::sleep(Duration::from_millis(10)),
        }
    }
}

fn from_hex(text: &str) -> Result<Vec<u8>> {
    let digits = |at| text.get(at..at + 2).ok_or("half a byte");
    (0..text.len()).step_by(2).map(|at| Ok(u8::from_str_radix(digits(at)?, 16)?)).collect()
}
