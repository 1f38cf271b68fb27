//! What a register does not allow does not compile, and the message says what to do instead.
//!
//! `TRYBUILD=overwrite cargo test -p canpac-pac-tests --test compile_fail` accepts changed messages.

#[test]
fn what_registers_do_not_allow_does_not_compile() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail/*.rs");
}
