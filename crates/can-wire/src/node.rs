//! One node: protocol engine, bit-timing unit and pins.

mod delay;
mod plain;

use std::collections::VecDeque;

use crate::{
    BitRecord, FdSupport, Field, Level, Mode, NodeConfig, Position, Time,
    bit_clock::{BitClock, Effect},
    fault::NodeFaults,
    protocol::{Context, Options, Protocol},
    time::Fine,
};

/// A change of the bus on its way to a node's input.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    at: u64,
    level: bool,
}

/// A bit whose secondary sample point is ahead.
#[derive(Clone, Copy, Debug)]
struct Late {
    at: Fine,
    level: bool,
    position: Position,
}

/// What a node wants the bus to do after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Output {
    None,
    /// The transmit output changes now.
    Pin(bool),
}

#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) config: NodeConfig,
    pub(crate) protocol: Protocol,
    pub(crate) clock: BitClock,
    /// Level of the transmit output, recessive while the mode keeps it so.
    pub(crate) pin: bool,
    /// Level that the bit-stream wants on the output since the last boundary; looped back in some modes.
    pub(crate) driven: bool,
    /// When the output follows the next bit of the engine.
    drive_at: Fine,
    /// The key of that change in the order of events, [`NEVER`] if there is none.
    drive_key: u64,
    /// Level at the receive input.
    pub(crate) rx: bool,
    /// Level of the bus at the receive input before faults.
    raw_rx: bool,
    arrivals: VecDeque<Arrival>,
    late: VecDeque<Late>,
    late_error: Option<(Position, Level)>,
    /// Transmitter delay measurement: when the output fell, until the input has followed.
    measuring: Option<Fine>,
    /// An edge came back before the filter window was over, and the input has been dominant since.
    early_edge: bool,
    /// Delay from output to input in clock periods, measured in the current frame.
    delay: Option<u64>,
    /// A dominant edge that counts only once it has lasted two quanta.
    filtered_edge: Option<Time>,
    pub(crate) faults: NodeFaults,
    /// The first dominant edge while the node is off is reported.
    pub(crate) wake_armed: bool,
    pub(crate) woken: Option<Time>,
    /// An edge has woken an idle node: it samples the bit that the edge began.
    awake: bool,
    /// Cut off from the bus in both directions.
    pub(crate) cut: bool,
    /// Every arrival is an event of its own, so that a trace gets it in time.
    pub(crate) eager: bool,
    /// Level of the input that the trace has been told.
    pub(crate) traced_rx: bool,
}

const NEVER: u64 = u64::MAX;

impl Node {
    pub(crate) fn new(config: NodeConfig) -> Node {
        Node {
            protocol: Protocol::new(Options::from(&config)),
            clock: BitClock::new(&config),
            config,
            pin: true,
            driven: true,
            drive_at: Fine::default(),
            drive_key: NEVER,
            rx: true,
            raw_rx: true,
            arrivals: VecDeque::new(),
            late: VecDeque::new(),
            late_error: None,
            measuring: None,
            early_edge: false,
            delay: None,
            filtered_edge: None,
            faults: NodeFaults::default(),
            wake_armed: false,
            woken: None,
            awake: false,
            cut: false,
            eager: false,
            traced_rx: true,
        }
    }

    /// The key of the node's next event: picoseconds times two, plus one for sample points, so that at equal times all
    /// outputs have changed before anyone samples.
    #[inline]
    pub(crate) fn next_key(&self) -> u64 {
        let key = if self.is_active() { self.clock.next_sample_at << 1 | 1 } else { NEVER };
        let key = key.min(self.drive_key);
        if self.late.is_empty() && self.arrivals.is_empty() {
            return key;
        }
        self.key_with_arrivals(key)
    }

    #[inline(never)]
    fn key_with_arrivals(&self, mut key: u64) -> u64 {
        if self.is_active()
            && let Some(late) = self.late.front()
        {
            key = key.min(late.at.ceil() << 1 | 1);
        }
        if let Some(at) = self.arrivals.front().map(|arrival| arrival.at)
            && (self.eager || self.watches_edges())
        {
            key = key.min(at << 1);
        }
        key
    }

    /// When the output follows the next bit of the engine, if it changes.
    pub(crate) fn drive_at(&self) -> Option<Fine> {
        (self.drive_key != NEVER).then_some(self.drive_at)
    }

    #[inline]
    fn set_drive(&mut self, at: Fine) {
        self.drive_at = at;
        self.drive_key = at.ceil() << 1;
    }

    #[inline]
    fn is_active(&self) -> bool {
        self.awake || !self.protocol.is_sleeping()
    }

    #[inline]
    fn watches_edges(&self) -> bool {
        self.clock.may_sync || self.measuring.is_some() || self.wake_armed || self.filtered_edge.is_some()
    }

    /// The level the node sees: its input, with what the mode loops back.
    #[inline]
    fn seen(&self) -> bool {
        match self.protocol.mode {
            Mode::ListenOnly => self.rx && self.driven,
            _ => self.rx,
        }
    }

    pub(crate) fn hears_itself(&self) -> bool {
        self.protocol.mode.is_loopback()
    }

    /// The bus changes at the node's input at `at`, now or later. Returns false if that cannot change when the node
    /// acts next.
    #[inline]
    pub(crate) fn bus_changed(&mut self, at: u64, level: bool, now: u64) -> bool {
        if at == now && self.arrivals.is_empty() {
            if self.takes_quietly(at, level) {
                return false;
            }
            let matters = if level { self.filtered_edge.is_some() } else { self.watches_edges() };
            self.input(Time::from_ps(at), level);
            return matters;
        }
        self.take_arrivals(now);
        if at == now {
            self.input(Time::from_ps(at), level);
        } else {
            self.arrivals.push_back(Arrival { at, level });
        }
        true
    }

    /// Takes in every arrival up to `now`.
    #[inline]
    pub(crate) fn take_arrivals(&mut self, now: u64) {
        while let Some(arrival) = self.arrivals.front().copied().filter(|arrival| arrival.at <= now) {
            self.arrivals.pop_front();
            self.input(Time::from_ps(arrival.at), arrival.level);
        }
    }

    fn input(&mut self, at: Time, level: bool) {
        self.raw_rx = level;
        self.apply_input(at);
    }

    /// Sets the input from the bus, the node's own output in loop back, and the faults that act on it.
    pub(crate) fn apply_input(&mut self, at: Time) {
        let level = if self.hears_itself() { self.driven } else { self.faults.received(self.raw_rx || self.cut) };
        if level == self.rx {
            return;
        }
        self.rx = level;
        if level {
            if self.early_edge {
                self.end_filter_window(at);
            }
            if let Some(since) = self.filtered_edge.take() {
                self.filter(since, at);
            }
        } else {
            self.dominant_edge(at);
        }
    }

    fn dominant_edge(&mut self, at: Time) {
        if let Some(fell) = self.measuring {
            self.measure(fell, at);
        }
        if self.protocol.field == Field::Off {
            if core::mem::take(&mut self.wake_armed) {
                self.woken = Some(at);
            }
            return;
        }
        if !self.clock.may_sync {
            return;
        }
        if self.protocol.field == Field::Integration && self.config.edge_filter {
            self.filtered_edge = Some(at);
            return;
        }
        if self.protocol.is_sleeping() && self.protocol.field == Field::Idle {
            self.clock.catch_up(at);
        }
        self.synchronize(at);
    }

    fn synchronize(&mut self, at: Time) {
        let before_sample = Fine::from_time(at) >= self.clock.start;
        let sync = self.protocol.sync(before_sample);
        if self.protocol.options.fd != FdSupport::Classic {
            self.protocol.edge_while_integrating();
        }
        let output_pending = self.drive_key != NEVER;
        if let Effect::Moved { output_from } = self.clock.edge(at, sync, !self.driven && before_sample)
            && output_pending
            && !before_sample
        {
            self.set_drive(output_from);
        }
        self.awake |= self.protocol.field == Field::Idle;
    }

    /// An output change that is due at `now`.
    pub(crate) fn drive(&mut self, now: u64) -> Output {
        if self.drive_key > now << 1 {
            return Output::None;
        }
        self.drive_key = NEVER;
        self.driven = self.protocol.drive;
        self.faults.next_bit();
        if !self.driven && self.starts_measurement() {
            self.measuring = Some(self.drive_at);
            self.early_edge = false;
            self.delay = None;
        }
        if self.hears_itself() {
            self.apply_input(Time::from_ps(now));
        }
        self.pin_output()
    }

    /// Recomputes the output from the engine, the mode and the faults.
    pub(crate) fn pin_output(&mut self) -> Output {
        let open = match self.protocol.mode {
            Mode::Off | Mode::ListenOnly | Mode::InternalLoopback => false,
            Mode::Normal | Mode::Restricted | Mode::ExternalLoopback => true,
        };
        let level = self.faults.driven(self.driven || !open);
        if level == self.pin {
            return Output::None;
        }
        self.pin = level;
        Output::Pin(level)
    }

    /// The sample point, or a secondary one, that is due at `now`. Tells whether a bit
    /// was sampled, and its record if that is asked for.
    #[inline]
    pub(crate) fn sample<const RECORD: bool>(&mut self, now: u64, cx: &mut Context<'_>) -> (bool, Option<BitRecord>) {
        if !self.late.is_empty() {
            self.compare_late(now);
        }
        if !self.is_active() || self.clock.next_sample_at > now {
            return (false, None);
        }
        if let Some(since) = self.filtered_edge.take() {
            self.filter(since, Time::from_ps(now));
            if self.clock.next_sample_at > now {
                return (false, None);
            }
        }
        let position = self.protocol.position();
        let (start, sample, role) = (self.clock.start, self.clock.next_sample, self.protocol.role);
        let driven = self.protocol.drive;
        let pin_level = self.seen();
        let compensated = self.config.delay_compensation.is_some() && self.protocol.relies_on_own_bits();
        let noisy = self.protocol.field != Field::Idle;
        let hit = self.faults.hits_sample(noisy);
        let level = if compensated { driven } else { pin_level ^ hit };
        let faulty = hit || self.faults.drives_wrong();
        let late = if self.late_error.is_some() { self.late_error.take() } else { None };
        self.awake = false;
        self.protocol.sample(level, late, cx);
        self.clock.sampled(level, self.protocol.data_phase);
        self.schedule_drive();
        if self.config.delay_compensation.is_some() {
            self.prepare_late_sample(position, cx);
        }
        if !RECORD {
            return (true, None);
        }
        // A receiver knows only now that this bit was a start of frame.
        let started = self.protocol.field == Field::BaseId && self.protocol.bit == 0 && !self.protocol.stuff_next;
        let position = if started { Position::new(Field::Sof, 0) } else { position };
        let record = BitRecord {
            node: cx.node,
            start: Time::from_ps(start.ceil()),
            sample: Time::from_ps(sample.ceil()),
            position,
            role,
            driven: Level::from_bit(driven),
            seen: Level::from_bit(level),
            faulty,
        };
        (true, Some(record))
    }

    /// The output follows the engine at the next bit boundary, if anything changes there.
    pub(crate) fn schedule_drive(&mut self) {
        if self.protocol.drive != self.driven || self.faults.drive_changes() {
            self.set_drive(self.clock.start);
        } else {
            self.drive_key = NEVER;
        }
    }

    /// An edge during bus integration that has to last two time quanta to count.
    fn filter(&mut self, since: Time, now: Time) {
        let quantum = self.clock.nominal.quantum;
        let lasted = Fine::from_time(now).ticks_since(Fine::from_time(since), quantum);
        if lasted >= 2 && self.clock.may_sync {
            self.synchronize(since);
        }
    }

    /// The node begins to count bits at `now`: it was switched on, or recovers from bus off.
    pub(crate) fn restart(&mut self, now: Time) {
        self.clock.restart(now);
        self.awake = false;
        self.late.clear();
        self.late_error = None;
        self.measuring = None;
        self.early_edge = false;
        self.filtered_edge = None;
    }

    /// The output follows the engine at once, not at a bit boundary: the mode has changed.
    pub(crate) fn follow_engine(&mut self, now: Time) -> Output {
        self.driven = self.protocol.drive;
        self.drive_key = NEVER;
        self.faults.break_off_bit();
        self.apply_input(now);
        self.pin_output()
    }

    /// Brings a sleeping node's bit grid up to date before a request wakes it.
    pub(crate) fn prepare_request(&mut self, now: Time) {
        if self.protocol.field == Field::Idle && !self.is_active() {
            self.clock.catch_up(now);
        }
    }

    pub(crate) fn has_arrivals(&self) -> bool {
        !self.arrivals.is_empty()
    }

    pub(crate) fn is_asleep(&self) -> bool {
        !self.is_active()
    }

    /// The end of a frame that was stepped over: the next bit is the last one of the intermission and begins at
    /// `start`. `bits` were sampled while the bus was not idle.
    pub(crate) fn finish_frame(&mut self, start: Fine, bits: u64, delay: Option<u64>) {
        self.clock.jump_to(start);
        self.delay = delay;
        if let Some(noise) = &mut self.faults.noise {
            noise.skip(bits);
        }
        self.driven = true;
        self.pin = true;
        self.drive_key = NEVER;
        self.awake = false;
    }
}
