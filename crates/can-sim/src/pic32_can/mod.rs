//! Microchip PIC32MX CAN, chapter by chapter of its manual.
