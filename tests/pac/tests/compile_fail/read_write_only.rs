use fixture_pac::Fixture;

fn look(block: &Fixture) -> u32 {
    block.command().read().bits()
}

fn main() {}
