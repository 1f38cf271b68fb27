use pic32_can_pac::Pic32Can;
use pic32_can_pac::registers::FifoCon;

fn send(can: &Pic32Can) {
    can.fifo(0).con().modify(|control| control | FifoCon::TXREQ);
}

fn main() {}
