//! Microchip dsPIC33 CAN FD, chapter by chapter of its manual.
