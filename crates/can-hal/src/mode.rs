//! Modes as types: the last letter of a controller's type says what it can do now.
//!
//! | mode | receives | acknowledges | sends |
//! |---|---|---|---|
//! | [`Configuration`] | no | no | no |
//! | [`Running`] | yes | yes | yes |
//! | [`LoopBack`] | its own frames | itself | yes |
//! | [`Restricted`] | yes | yes | no |
//! | [`ListenOnly`] | yes | no | no |
//! | [`Asleep`] | no | no | no |

/// Off the bus; the configuration can be changed.
#[derive(Debug)]
pub enum Configuration {}

/// Takes part in the traffic on the bus.
#[derive(Debug)]
pub enum Running {}

/// Receives what it sends, needs nobody's acknowledgement.
#[derive(Debug)]
pub enum LoopBack {}

/// Receives and acknowledges, sends no frames and no error flags.
#[derive(Debug)]
pub enum Restricted {}

/// Receives and sends nothing at all, not even an acknowledgement.
#[derive(Debug)]
pub enum ListenOnly {}

/// Stopped to save power.
#[derive(Debug)]
pub enum Asleep {}

mod sealed {
    pub trait Sealed {}
}

/// A mode in which the controller receives.
pub trait OnBus: sealed::Sealed {}

/// A mode in which the controller sends.
#[diagnostic::on_unimplemented(
    message = "a controller in mode `{Self}` does not send",
    note = "`Running` and `LoopBack` do"
)]
pub trait Sends: OnBus {}

macro_rules! modes {
    ($($mode:ident: $($is:ident)*;)*) => {$(
        impl sealed::Sealed for $mode {}
        $(impl $is for $mode {})*
    )*};
}

modes! {
    Running: OnBus Sends;
    LoopBack: OnBus Sends;
    Restricted: OnBus;
    ListenOnly: OnBus;
}
