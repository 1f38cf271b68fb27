//! The story: what the drivers are told to do, and what is done to the bus.

use std::sync::{Arc, Mutex, PoisonError};

use can_frame::Frame;
use can_hal::{
    ErrorState, Events, Outcome, Polls, Receive as _, RestartAfter, Status, Transmit,
    timing::{BitTiming, Request, Segments},
};
use can_sim::Sim;
use can_wire::{BitFault, Fault, Field, Frames, NodeConfig, NodeId, Position, Time, output::Recording};

use crate::{
    Error, Story,
    controllers::{MODE_POLLS, Station},
    story::{Act, Deed, Injected, Node, Step},
};

/// Nominal bit rate in bit/s.
pub const RATE: u32 = 500_000;
/// Bit rate of the data phase of FD frames in bit/s.
pub const DATA_RATE: u32 = 2_000_000;
/// How long the driver leaves a node off the bus before it restarts it.
pub const PAUSE: Time = Time::from_us(1_000);
/// When the first frame is sent; both controllers are on the bus by then.
const FIRST: Time = Time::from_us(120);
/// When the fault is repaired, counted from bus off.
const REPAIRED: Time = Time::from_us(500);
/// How often the driver of a node that is bus off looks at its state.
const TICK: Time = Time::from_us(200);
/// Time between two frames of the panel while the motor is bus off.
const PERIOD: Time = Time::from_us(800);
/// Delay of each node's transceiver in each direction.
const DELAY: Time = Time::from_ns(80);
/// Longer than anything that the story waits for should take.
const PATIENCE: Time = Time::from_ms(20);

/// The disturbed node.
pub const MOTOR: usize = 0;
/// The other controller.
pub const PANEL: usize = 1;
/// A node without registers, so that the panel has somebody to acknowledge its frames.
pub const LOGGER: usize = 2;

/// The bit that is disturbed: a recessive one, in the third byte of `SPEED`.
pub const VICTIM: Position = Position::new(Field::Data, 20);
/// Names of the nodes.
const NAMES: [&str; 3] = ["motor", "panel", "logger"];
/// How far the clocks are off, in parts per million.
const PPM: [i32; 3] = [40, -60, 20];

/// Frames of the motor, apart from the last byte, which counts.
const SPEED: &str = "120#0BB83C00FA01";
/// A frame of the panel that goes before those of the motor.
const BUTTON: &str = "0F0#01";
/// A longer one, as FD frame with bit-rate switch and as classic frame.
const DISPLAY: [&str; 2] = ["3A0##148656C6C6F2C206D6F746F7221000000", "3A0#48656C6C6F000000"];

/// What a controller's bit timing is asked to be.
#[must_use]
pub const fn request(clock: u32) -> Request {
    Request::new(clock, RATE).data(DATA_RATE)
}

fn frame(text: &str) -> Result<Frame, Error> {
    text.parse().map_err(|_| Error::Frame(text.to_owned()))
}

/// A controller with its driver.
struct Actor<'a, S: Station> {
    node: usize,
    station: S,
    can: S::Driver<'a>,
    pending: Vec<(<S::Driver<'a> as Transmit>::Ticket, Frame)>,
    sent: u32,
    status: Option<Status>,
}

impl<S: Station> Actor<'_, S> {
    /// The interrupt handler.
    fn serve(&mut self) -> Result<Deed, Error> {
        let events = S::take_events(&mut self.can)?;
        let mut received = Vec::new();
        while let Some(message) = self.can.fetch().map_err(Error::setup)? {
            received.push(message.frame);
        }
        let mut sent = Vec::new();
        if events.contains(Events::TRANSMITTED) {
            let (can, done) = (&mut self.can, &mut sent);
            self.pending.retain(|(ticket, frame)| {
                let pending = can.outcome(*ticket) == Outcome::Pending;
                if !pending {
                    done.push(*frame);
                }
                pending
            });
        }
        self.sent += sent.len() as u32;
        let reasons = [Events::WARNING, Events::PASSIVE, Events::BUS_OFF, Events::PROTOCOL_ERROR];
        let status = reasons.iter().any(|reason| events.intersects(*reason)).then(|| self.can.status());
        self.status = status.or(self.status);
        Ok(Deed::Served { events, received, sent, status })
    }

    fn send(&mut self, frame: Frame) -> Result<Deed, Error> {
        let ticket = self.can.send(&frame).map_err(Error::Send)?;
        self.pending.push((ticket, frame));
        Ok(Deed::Sent(frame))
    }

    fn look(&mut self) -> Deed {
        let status = self.can.status();
        self.status = Some(status);
        Deed::Looked(status)
    }

    fn is(&self, state: ErrorState) -> bool {
        self.status.is_some_and(|status| status.error_state == state)
    }
}

/// The simulation with both drivers.
struct Stage<'a, A: Station, B: Station> {
    sim: &'a Sim,
    motor: Actor<'a, A>,
    panel: Actor<'a, B>,
    steps: Vec<Step>,
    acts: Vec<Act>,
    faults: Vec<Injected>,
    counter: u8,
}

/// Notes what a driver has done since the last note.
fn note(sim: &Sim, steps: &mut Vec<Step>, node: usize, time: Time, deed: Deed) {
    steps.push(Step { time, node, deed, records: sim.trace(true) });
}

/// Brings a controller on the bus.
fn start<'a, S: Station>(
    sim: &'a Sim,
    steps: &mut Vec<Step>,
    node: usize,
    station: S,
    timing: &BitTiming,
) -> Result<Actor<'a, S>, Error> {
    let begin = sim.now();
    let can = station.configure(sim, timing)?;
    note(sim, steps, node, begin, Deed::Configured);
    let begin = sim.now();
    let can = S::start(can)?;
    note(sim, steps, node, begin, Deed::Started);
    Ok(Actor { node, station, can, pending: Vec::new(), sent: 0, status: None })
}

impl<A: Station, B: Station> Stage<'_, A, B> {
    fn act(&mut self, title: &'static str) {
        self.act_from(title, self.sim.now());
    }

    fn act_from(&mut self, title: &'static str, now: Time) {
        if let Some(last) = self.acts.last_mut() {
            last.until = now;
        }
        self.acts.push(Act { title, from: now, until: now });
    }

    /// Serves both controllers as long as one of their interrupt lines is active.
    fn serve(&mut self) -> Result<(), Error> {
        for _ in 0..1_000 {
            let begin = self.sim.now();
            if self.motor.station.line(self.sim) {
                let deed = self.motor.serve()?;
                note(self.sim, &mut self.steps, self.motor.node, begin, deed);
            } else if self.panel.station.line(self.sim) {
                let deed = self.panel.serve()?;
                note(self.sim, &mut self.steps, self.panel.node, begin, deed);
            } else {
                return Ok(());
            }
        }
        Err(Error::Stuck { waiting_for: "an interrupt line to become inactive", time: self.sim.now() })
    }

    /// Lets the drivers do their work until something is as it should be.
    fn wait_for(&mut self, what: &'static str, done: impl Fn(&Self) -> bool) -> Result<(), Error> {
        let end = self.sim.now() + PATIENCE;
        loop {
            self.serve()?;
            if done(self) {
                return Ok(());
            }
            if self.sim.now() >= end {
                return Err(Error::Stuck { waiting_for: what, time: self.sim.now() });
            }
            let (motor, panel) = (self.motor.station, self.panel.station);
            self.sim.run_until(end.since(self.sim.now()), |sim| motor.line(sim) || panel.line(sim));
        }
    }

    /// Lets the drivers do their work for a while, or until the motor's driver sees another error state.
    fn serve_until(&mut self, until: Time) -> Result<(), Error> {
        let state = |stage: &Self| stage.motor.status.map(|status| status.error_state);
        let before = state(self);
        while self.sim.now() < until && state(self) == before {
            let (motor, panel) = (self.motor.station, self.panel.station);
            self.sim.run_until(until.since(self.sim.now()), |sim| motor.line(sim) || panel.line(sim));
            self.serve()?;
        }
        Ok(())
    }

    fn serve_for(&mut self, span: Time) -> Result<(), Error> {
        self.serve_until(self.sim.now() + span)
    }

    /// The motor's driver sends its speed.
    fn motor_sends(&mut self) -> Result<(), Error> {
        self.counter += 1;
        let begin = self.sim.now();
        let deed = self.motor.send(frame(&format!("{SPEED}{:02X}", self.counter))?)?;
        note(self.sim, &mut self.steps, self.motor.node, begin, deed);
        Ok(())
    }

    fn panel_sends(&mut self, text: &str) -> Result<(), Error> {
        let begin = self.sim.now();
        let deed = self.panel.send(frame(text)?)?;
        note(self.sim, &mut self.steps, self.panel.node, begin, deed);
        Ok(())
    }

    /// Waits until all frames are sent, and a little longer.
    fn all_sent(&mut self) -> Result<(), Error> {
        self.wait_for("frames to be sent", |stage| stage.motor.pending.is_empty() && stage.panel.pending.is_empty())?;
        self.serve_for(Time::from_us(60))
    }

    /// The motor's driver wants to hear of single errors, or not.
    fn report_errors(&mut self, on: bool) {
        let begin = self.sim.now();
        A::report_errors(&mut self.motor.can, on);
        note(self.sim, &mut self.steps, self.motor.node, begin, Deed::ReportsErrors(on));
    }

    /// The faults are over.
    fn undisturbed(&mut self) {
        let now = self.sim.now();
        self.faults.iter_mut().filter(|fault| fault.until.is_none()).for_each(|fault| fault.until = Some(now));
    }

    /// Disturbs the next frames of the motor.
    fn disturb(&mut self, victim: NodeId, frames: u32) {
        let fault = Fault::Bit {
            node: victim,
            fault: BitFault::InvertDriven,
            position: VICTIM,
            frames: Frames { sender: Some(victim), skip: 0, count: frames },
        };
        self.sim.with_wire(|wire| wire.inject(fault));
        let time = self.sim.now();
        self.faults.push(Injected { time, node: MOTOR, position: VICTIM, frames, until: None });
    }
}

/// Plays the story with two controllers.
///
/// # Errors
/// An [`Error`] if a driver does not get where the story wants it.
pub fn play<A: Station, B: Station>() -> Result<Story, Error> {
    let sim = Sim::new();
    let (a, b) = (A::add(&sim, NAMES[MOTOR], PPM[MOTOR])?, B::add(&sim, NAMES[PANEL], PPM[PANEL])?);
    let timing = (A::timing()?, B::timing()?);
    let logger = sim.add_peer(plain_node(A::CLOCK, &timing.0)).map_err(Error::Place)?;
    let recording = Arc::new(Mutex::new(Recording::new()));
    sim.with_wire(|wire| wire.set_trace(Some(Box::new(Arc::clone(&recording)))));
    let display = DISPLAY[usize::from(!(A::FD && B::FD))];
    let node =
        |index: usize, title, id, clock, timing| Node { name: NAMES[index], title, id, clock, ppm: PPM[index], timing };
    let nodes = vec![
        node(MOTOR, A::META.title, a.node(&sim), A::CLOCK, Some(timing.0)),
        node(PANEL, B::META.title, b.node(&sim), B::CLOCK, Some(timing.1)),
        node(LOGGER, "a plain node of the bus, without registers", sim.peer_node(logger), A::CLOCK, None),
    ];

    let mut steps = Vec::new();
    sim.trace(true);
    let motor = start(&sim, &mut steps, MOTOR, a, &timing.0)?;
    let panel = start(&sim, &mut steps, PANEL, b, &timing.1)?;
    let mut stage = Stage { sim: &sim, motor, panel, steps, acts: Vec::new(), faults: Vec::new(), counter: 0 };
    script(&mut stage, display)?;

    let end = sim.now();
    let Stage { steps, mut acts, faults, .. } = stage;
    acts.first_mut().into_iter().for_each(|act| act.from = Time::ZERO);
    acts.last_mut().into_iter().for_each(|act| act.until = end);
    sim.with_wire(|wire| wire.set_trace(None));
    let recording = recording.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let diagnostics = sim.diagnostics().iter().map(ToString::to_string).collect();
    let data_rate = (display == DISPLAY[0]).then_some(DATA_RATE);
    let files = Vec::new();
    Ok(Story { nodes, rate: RATE, data_rate, pause: PAUSE, acts, faults, steps, recording, diagnostics, end, files })
}

/// What happens, act by act.
fn script<A: Station, B: Station>(stage: &mut Stage<'_, A, B>, display: &str) -> Result<(), Error> {
    let motor = stage.motor.station.node(stage.sim);

    stage.act("Two controllers talk");
    stage.serve_until(FIRST)?;
    stage.motor_sends()?;
    stage.all_sent()?;
    // Both get their next frames while this one occupies the bus, so that they begin together.
    stage.panel_sends(display)?;
    stage.serve_for(Time::from_us(60))?;
    stage.motor_sends()?;
    stage.panel_sends(BUTTON)?;
    stage.all_sent()?;

    stage.act("One bit is disturbed");
    stage.disturb(motor, 1);
    stage.motor_sends()?;
    stage.all_sent()?;
    stage.undisturbed();

    stage.act("The fault stays");
    stage.disturb(motor, u32::MAX);
    stage.motor_sends()?;
    stage.wait_for("the motor to become error passive", |stage| stage.motor.is(ErrorState::Passive))?;
    stage.panel_sends(BUTTON)?;
    stage.wait_for("the motor to go bus off", |stage| stage.motor.is(ErrorState::BusOff))?;

    stage.act("Bus off, and the way back");
    let off = stage.sim.now();
    stage.report_errors(false);
    let mut policy = RestartAfter::new(PAUSE.as_ps());
    let mut next_frame = off + PERIOD;
    let mut fault = true;
    while !stage.motor.is(ErrorState::Active) {
        let now = stage.sim.now();
        if now >= off + PATIENCE {
            return Err(Error::Stuck { waiting_for: "the motor to come back from bus off", time: now });
        }
        if fault && now >= off + REPAIRED {
            fault = false;
            stage.sim.with_wire(can_wire::Wire::clear_faults);
            stage.undisturbed();
        }
        if now >= next_frame {
            next_frame += PERIOD;
            stage.panel_sends(BUTTON)?;
        }
        let deed = stage.motor.look();
        note(stage.sim, &mut stage.steps, MOTOR, now, deed);
        let bus_off = stage.motor.is(ErrorState::BusOff);
        let begin = stage.sim.now();
        if policy.due(bus_off, begin.as_ps()) {
            let begun = stage.motor.can.restart(Polls(MODE_POLLS));
            begun.map_err(|_| Error::TimedOut("to recover from bus off"))?;
            note(stage.sim, &mut stage.steps, MOTOR, begin, Deed::Restarted);
        }
        stage.serve_until(now + TICK)?;
    }

    // With the interrupt that has told the driver.
    let back = stage.steps.last().map_or(stage.sim.now(), |step| step.time);
    stage.act_from("Back on the bus", back);
    stage.report_errors(true);
    stage.all_sent()?;
    stage.motor_sends()?;
    stage.all_sent()?;
    stage.panel_sends(display)?;
    stage.all_sent()
}

/// The node that only listens and acknowledges.
fn plain_node(clock: u32, timing: &BitTiming) -> NodeConfig {
    let of = |segments: &Segments| can_wire::BitTiming {
        prescaler: segments.prescaler as u16,
        prop_seg: segments.propagation as u16,
        phase_seg1: segments.phase1 as u16,
        phase_seg2: segments.phase2 as u16,
        sjw: segments.jump_width as u16,
    };
    let mut place = place(clock, PPM[LOGGER]);
    place.nominal = of(&timing.nominal);
    if let Some(data) = &timing.data {
        place.data = of(&data.segments);
    }
    place
}

/// A place on the bus: a clock and the delays of a transceiver.
#[must_use]
pub fn place(clock: u32, ppm: i32) -> NodeConfig {
    NodeConfig { clock_hz: clock, clock_ppm: ppm, tx_delay: DELAY, rx_delay: DELAY, ..NodeConfig::new() }
}
