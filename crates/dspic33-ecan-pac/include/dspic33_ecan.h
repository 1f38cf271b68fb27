/* Microchip dsPIC33F/PIC24H Enhanced CAN (ECAN): registers and message layouts.
 * CAN 2.0B controller of the dsPIC33F and PIC24H families, up to 1 Mbit/s, at most two per device. Its 32
 * message buffers of eight words lie in DMA RAM; buffers 0 to 7 transmit or receive, the others receive, and a
 * run of buffers can serve as a receive FIFO. One DMA channel moves messages to the module and a second one from
 * it. Sixteen acceptance filters share three masks. The registers are banked by CxCTRL1.WIN.
 * Described after Enhanced Controller Area Network (CAN), dsPIC33F/PIC24H Family Reference Manual, Microchip
 * Technology Inc., revision D.
 * Generated from the description of the controller; changes belong there.
 * C99 or C++11. A field FIELD of a register REG has DSPIC33_ECAN_REG_FIELD_Pos, _Msk, _Width and _Access; a
 * field that is repeated in its register takes the number of the lane, counted from 0, as an argument.
 * Access codes: rw, ro, wo; w1c and w0c are flags cleared by writing 1 or 0; w1s is a request made by writing 1;
 * rwhc a request that 0 withdraws; rwh is changed by hardware too; wclr is cleared or preset by any write; +rc
 * and +rs are cleared or set by a read, @n of byte n; a condition for writing stands behind the colon.
 * Define DSPIC33_ECAN_ASSERT(condition) to have ranges and indices checked at run time.
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef DSPIC33_ECAN_H
#define DSPIC33_ECAN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__cplusplus)
#define DSPIC33_ECAN_STATIC_ASSERT(condition, name) static_assert(condition, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define DSPIC33_ECAN_STATIC_ASSERT(condition, name) _Static_assert(condition, #name)
#else
#define DSPIC33_ECAN_STATIC_ASSERT(condition, name) typedef char name[(condition) ? 1 : -1]
#endif

#ifndef DSPIC33_ECAN_ASSERT
#define DSPIC33_ECAN_ASSERT(condition) ((void)0)
#endif

/* A register that software can only read. C++ wants every const member initialized. */
#ifdef __cplusplus
#define DSPIC33_ECAN_READ_ONLY volatile
#else
#define DSPIC33_ECAN_READ_ONLY volatile const
#endif

/* Values of CTRL1.REQOP, CTRL1.OPMODE.
 * Operating modes, as requested and as reported.
 * Register 4-23 p.30
 */
/* Transmits and receives. */
#define DSPIC33_ECAN_OPERATION_MODE_NORMAL 0U
/* Module clocks stopped and CxTX recessive. */
#define DSPIC33_ECAN_OPERATION_MODE_DISABLE 1U
/* Transmit path connected to the receive path inside the module. */
#define DSPIC33_ECAN_OPERATION_MODE_LOOPBACK 2U
/* Watches the bus without acknowledging and without error frames. */
#define DSPIC33_ECAN_OPERATION_MODE_LISTEN_ONLY 3U
/* Bit timing can be written; the mode after reset. */
#define DSPIC33_ECAN_OPERATION_MODE_CONFIGURATION 4U
/* Receives every message, those with errors included. */
#define DSPIC33_ECAN_OPERATION_MODE_LISTEN_ALL 7U

/* Values of FMSKSEL.FMSK.
 * Mask that an acceptance filter uses.
 * Register 4-8 p.19; Table 9-1 p.52
 */
/* Acceptance mask 0. */
#define DSPIC33_ECAN_MASK_SOURCE_MASK_0 0U
/* Acceptance mask 1. */
#define DSPIC33_ECAN_MASK_SOURCE_MASK_1 1U
/* Acceptance mask 2. */
#define DSPIC33_ECAN_MASK_SOURCE_MASK_2 2U

/* Values of BUFPNT.FBP.
 * Where a message that hits a filter is stored.
 * Register 4-10 p.20; §9.2.1 p.56
 */
/* Message buffer of this number. */
#define DSPIC33_ECAN_FILTER_TARGET_BUFFER_FIRST 0U
#define DSPIC33_ECAN_FILTER_TARGET_BUFFER_LAST 14U
/* The receive FIFO, not message buffer 15. */
#define DSPIC33_ECAN_FILTER_TARGET_FIFO 15U

/* Values of FIFO.FBP, FIFO.FNRB.
 * Message buffer that a FIFO pointer names. Codes above 31 are not listed and taken as reserved.
 * Register 4-19 p.26
 */
/* Transmit or receive buffer of this number. */
#define DSPIC33_ECAN_FIFO_BUFFER_TRB_FIRST 0U
#define DSPIC33_ECAN_FIFO_BUFFER_TRB_LAST 7U
/* Receive buffer of this number. */
#define DSPIC33_ECAN_FIFO_BUFFER_RB_FIRST 8U
#define DSPIC33_ECAN_FIFO_BUFFER_RB_LAST 31U

/* Values of TRCON.TXPRI.
 * Priority of a transmit buffer. Among equal priorities the buffer with the highest number goes first.
 * §8.1 p.43
 */
/* Lowest priority. */
#define DSPIC33_ECAN_TX_PRIORITY_LOWEST 0U
/* Second lowest priority. */
#define DSPIC33_ECAN_TX_PRIORITY_INTERMEDIATE_LOW 1U
/* Second highest priority. */
#define DSPIC33_ECAN_TX_PRIORITY_INTERMEDIATE_HIGH 2U
/* Highest priority. */
#define DSPIC33_ECAN_TX_PRIORITY_HIGHEST 3U

/* Values of FCTRL.DMABS.
 * Number of message buffers in DMA RAM. The manual lists the seven sizes in this order and prints only code 3
 * for 12; the other codes follow from the order and from outside sources.
 * §9.3 p.57; external: faq_665; external: driver_dmabs; external: driver_icode
 */
/* 4 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_4 0U
/* 6 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_6 1U
/* 8 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_8 2U
/* 12 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_12 3U
/* 16 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_16 4U
/* 24 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_24 5U
/* 32 buffers. */
#define DSPIC33_ECAN_BUFFER_COUNT_BUFFERS_32 6U

/* Values of VEC.FILHIT.
 * Number of an acceptance filter. There are sixteen, so the field never shows the other codes.
 * §5.0 Buffer 5-8 p.37; §1.0 p.2
 */
/* Acceptance filter of this number. */
#define DSPIC33_ECAN_FILTER_NUMBER_FILTER_FIRST 0U
#define DSPIC33_ECAN_FILTER_NUMBER_FILTER_LAST 15U

/* Values of VEC.ICODE.
 * Codes of the event interrupt. The page that lists them is missing from the cited copy.
 * external: driver_icode; §12.3 p.69
 */
/* Transmit or receive buffer of this number. */
#define DSPIC33_ECAN_INTERRUPT_CODE_TRB_FIRST 0U
#define DSPIC33_ECAN_INTERRUPT_CODE_TRB_LAST 7U
/* Receive buffer of this number. */
#define DSPIC33_ECAN_INTERRUPT_CODE_RB_FIRST 8U
#define DSPIC33_ECAN_INTERRUPT_CODE_RB_LAST 31U
/* No interrupt is pending. */
#define DSPIC33_ECAN_INTERRUPT_CODE_NO_INTERRUPT 64U
/* Error interrupt. */
#define DSPIC33_ECAN_INTERRUPT_CODE_ERROR 65U
/* Wake-up interrupt. */
#define DSPIC33_ECAN_INTERRUPT_CODE_WAKE_UP 66U
/* Receive buffer overflow. */
#define DSPIC33_ECAN_INTERRUPT_CODE_RECEIVER_OVERFLOW 67U
/* FIFO almost full. */
#define DSPIC33_ECAN_INTERRUPT_CODE_FIFO_ALMOST_FULL 68U

/* Values of RXFSID.EXIDE.
 * Length of the identifier.
 * Register 4-4 p.17; §2.0 p.4
 */
/* 11-bit identifier. */
#define DSPIC33_ECAN_IDENTIFIER_FORMAT_STANDARD 0U
/* 29-bit identifier. */
#define DSPIC33_ECAN_IDENTIFIER_FORMAT_EXTENDED 1U

/* Values of CTRL1.WIN.
 * Register 4-23 p.30; external: linker_mc710 (offset)
 */
/* Buffer window. */
#define DSPIC33_ECAN_CTRL1_WIN_BUFFER 0U
/* Filter window. */
#define DSPIC33_ECAN_CTRL1_WIN_FILTER 1U

/* Values of CTRL2.DNCNT.
 * Register 4-24 p.31; external: linker_mc710 (offset)
 */
/* Data bytes are not compared. */
#define DSPIC33_ECAN_CTRL2_DNCNT_OFF 0U
/* This many data bits, from bit 7 of byte 0 on, are compared with EID[17] downwards. */
#define DSPIC33_ECAN_CTRL2_DNCNT_DATA_BITS_FIRST 1U
#define DSPIC33_ECAN_CTRL2_DNCNT_DATA_BITS_LAST 18U

/* Values of CFG2.SEG2PHTS.
 * Register 4-2 p.16; §7.1 p.42; external: linker_mc710 (offset)
 */
/* Phase segment 1 or the information processing time, whichever is longer. */
#define DSPIC33_ECAN_CFG2_SEG2PHTS_SEG1PH_OR_IPT 0U
/* Length given by SEG2PH. */
#define DSPIC33_ECAN_CFG2_SEG2PHTS_PROGRAMMABLE 1U

/* Values of CFG2.SAM.
 * Register 4-2 p.16; §7.1 p.42; external: linker_mc710 (offset)
 */
/* One sample at the sample point. */
#define DSPIC33_ECAN_CFG2_SAM_ONCE 0U
/* Three samples; the majority counts. */
#define DSPIC33_ECAN_CFG2_SAM_THREE_TIMES 1U

/* Values of TRCON.TXEN.
 * Table 3-2 p.9; Table 3-5 p.12; §8.1 p.43; Register 4-25 p.32; external: header_mc710 (bit positions);
 * external: frm_dspic30f (access and meaning of TXABT); external: linker_mc710 (offset)
 */
/* Receive buffer. */
#define DSPIC33_ECAN_TR_CON_TXEN_RECEIVE 0U
/* Transmit buffer. */
#define DSPIC33_ECAN_TR_CON_TXEN_TRANSMIT 1U

/* Values of RXMSID.MIDE.
 * Register 4-6 p.18; Table 9-2 p.52; external: linker_mc710 (offset)
 */
/* EXIDE is ignored and messages of both formats can match. */
#define DSPIC33_ECAN_RXM_SID_MIDE_BOTH_FORMATS 0U
/* Only messages of the format that EXIDE of the filter selects match. */
#define DSPIC33_ECAN_RXM_SID_MIDE_BY_EXIDE 1U

/* The register block. */
typedef struct dspic33_ecan_regs {
    volatile uint16_t CTRL1; /* CAN Control Register 1 */
    volatile uint16_t CTRL2; /* CAN Control Register 2 */
    DSPIC33_ECAN_READ_ONLY uint16_t VEC; /* CAN Interrupt Code Register */
    volatile uint16_t FCTRL; /* CAN FIFO Control Register */
    DSPIC33_ECAN_READ_ONLY uint16_t FIFO; /* CAN FIFO Status Register */
    volatile uint16_t INTF; /* CAN Interrupt Flag Register */
    volatile uint16_t INTE; /* CAN Interrupt Enable Register */
    DSPIC33_ECAN_READ_ONLY uint16_t EC; /* CAN Transmit/Receive Error Count Register */
    volatile uint16_t CFG1; /* CAN Baud Rate Configuration Register 1 */
    volatile uint16_t CFG2; /* CAN Baud Rate Configuration Register 2 */
    volatile uint16_t FEN1; /* CAN Acceptance Filter Enable Register */
    uint8_t RESERVED_016[2];
    volatile uint16_t FMSKSEL[2]; /* CAN Filter Mask Selection Register */
    uint8_t RESERVED_01C[4];
    union {
        struct {
            volatile uint16_t RXFUL[2]; /* CAN Receive Buffer Full Register */
            uint8_t RESERVED_004[4];
            volatile uint16_t RXOVF[2]; /* CAN Receive Buffer Overflow Register */
            uint8_t RESERVED_00C[4];
            volatile uint16_t TRCON[4]; /* CAN TX/RX Buffer Control Register */
            uint8_t RESERVED_018[8];
            volatile uint16_t RXD; /* CAN Receive Data Register */
            volatile uint16_t TXD; /* CAN Transmit Data Register */
        } BUFFER;
        struct {
            volatile uint16_t BUFPNT[4]; /* CAN Filter Buffer Pointer Register */
            uint8_t RESERVED_008[8];
            struct {
                volatile uint16_t RXMSID; /* CAN Acceptance Filter Mask Standard Identifier Register */
                volatile uint16_t RXMEID; /* CAN Acceptance Filter Mask Extended Identifier Register */
            } RXM[3];
            uint8_t RESERVED_01C[4];
            struct {
                volatile uint16_t RXFSID; /* CAN Acceptance Filter Standard Identifier Register */
                volatile uint16_t RXFEID; /* CAN Acceptance Filter Extended Identifier Register */
            } RXF[16];
        } FILTER;
    } WINDOW;
} dspic33_ecan_regs_t;

DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, CTRL1) == 0x000U, dspic33_ecan_at_CTRL1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, CTRL2) == 0x002U, dspic33_ecan_at_CTRL2);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, VEC) == 0x004U, dspic33_ecan_at_VEC);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, FCTRL) == 0x006U, dspic33_ecan_at_FCTRL);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, FIFO) == 0x008U, dspic33_ecan_at_FIFO);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, INTF) == 0x00AU, dspic33_ecan_at_INTF);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, INTE) == 0x00CU, dspic33_ecan_at_INTE);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, EC) == 0x00EU, dspic33_ecan_at_EC);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, CFG1) == 0x010U, dspic33_ecan_at_CFG1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, CFG2) == 0x012U, dspic33_ecan_at_CFG2);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, FEN1) == 0x014U, dspic33_ecan_at_FEN1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, FMSKSEL[0]) == 0x018U, dspic33_ecan_at_FMSKSEL_0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, FMSKSEL[1]) == 0x01AU, dspic33_ecan_at_FMSKSEL_1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.RXFUL[0]) == 0x020U, dspic33_ecan_at_WINDOW_BUFFER_RXFUL_0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.RXFUL[1]) == 0x022U, dspic33_ecan_at_WINDOW_BUFFER_RXFUL_1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.RXOVF[0]) == 0x028U, dspic33_ecan_at_WINDOW_BUFFER_RXOVF_0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.RXOVF[1]) == 0x02AU, dspic33_ecan_at_WINDOW_BUFFER_RXOVF_1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.TRCON[0]) == 0x030U, dspic33_ecan_at_WINDOW_BUFFER_TRCON_0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.TRCON[1]) == 0x032U, dspic33_ecan_at_WINDOW_BUFFER_TRCON_1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.RXD) == 0x040U, dspic33_ecan_at_WINDOW_BUFFER_RXD);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.BUFFER.TXD) == 0x042U, dspic33_ecan_at_WINDOW_BUFFER_TXD);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.BUFPNT[0]) == 0x020U, dspic33_ecan_at_WINDOW_FILTER_BUFPNT_0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.BUFPNT[1]) == 0x022U, dspic33_ecan_at_WINDOW_FILTER_BUFPNT_1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXM[0].RXMSID) == 0x030U, dspic33_ecan_at_WINDOW_FILTER_RXM_0__RXMSID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXM[0].RXMEID) == 0x032U, dspic33_ecan_at_WINDOW_FILTER_RXM_0__RXMEID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXM[1].RXMSID) == 0x034U, dspic33_ecan_at_WINDOW_FILTER_RXM_1__RXMSID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXM[1].RXMEID) == 0x036U, dspic33_ecan_at_WINDOW_FILTER_RXM_1__RXMEID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXF[0].RXFSID) == 0x040U, dspic33_ecan_at_WINDOW_FILTER_RXF_0__RXFSID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXF[0].RXFEID) == 0x042U, dspic33_ecan_at_WINDOW_FILTER_RXF_0__RXFEID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXF[1].RXFSID) == 0x044U, dspic33_ecan_at_WINDOW_FILTER_RXF_1__RXFSID);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_regs_t, WINDOW.FILTER.RXF[1].RXFEID) == 0x046U, dspic33_ecan_at_WINDOW_FILTER_RXF_1__RXFEID);
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_regs_t) == 0x080U, dspic33_ecan_span);

/* CTRL1: CAN Control Register 1.
 * Operating mode, abort of all transmissions, register window and time stamp capture.
 * Hazard: Changing WIN changes which registers lie behind the offsets 0x20 to 0x7F; an interrupt routine that
 * clears RXFUL while the filter window is selected writes a filter register instead.
 * Hazard: Bit 11 is reserved and must stay 0. On some devices it was the clock select bit CANCKS.
 * Hazard: A mode is reached only when OPMODE shows it; the change waits for 11 recessive bits on the bus.
 * Contradictions of the manual: cancks.
 * Register 4-23 p.30; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_CTRL1_OFFSET 0x000U
#define DSPIC33_ECAN_CTRL1_RESET 0x0480U
#define DSPIC33_ECAN_CTRL1_RESET_MASK 0xFFFFU
/* CSIDL: Stop in Idle. With 1 the module stops while the CPU is in Idle mode, with 0 it goes on. Access rw.
 * Contradictions of the manual: idle_mode.
 * Register 4-23 p.30; §13.2 p.72
 */
#define DSPIC33_ECAN_CTRL1_CSIDL_Pos 13U
#define DSPIC33_ECAN_CTRL1_CSIDL_Msk 0x2000U
#define DSPIC33_ECAN_CTRL1_CSIDL_Width 1U
#define DSPIC33_ECAN_CTRL1_CSIDL_Access "rw"
#define DSPIC33_ECAN_CTRL1_CSIDL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CTRL1_CSIDL_Pos) & DSPIC33_ECAN_CTRL1_CSIDL_Msk))
static inline uint16_t dspic33_ecan_ctrl1_csidl_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_CSIDL_Msk) >> DSPIC33_ECAN_CTRL1_CSIDL_Pos);
}
static inline uint16_t dspic33_ecan_ctrl1_csidl_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CTRL1_CSIDL_Msk) | DSPIC33_ECAN_CTRL1_CSIDL_SET(value));
}
/* ABAT: Writing 1 asks for the abort of all pending transmissions. The module clears the bit when all of them
 * are aborted. A frame that is already on the bus is aborted only if it loses arbitration or meets an error.
 * Access w1s. A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
 * Register 4-23 p.30; §8.2 p.47
 */
#define DSPIC33_ECAN_CTRL1_ABAT_Pos 12U
#define DSPIC33_ECAN_CTRL1_ABAT_Msk 0x1000U
#define DSPIC33_ECAN_CTRL1_ABAT_Width 1U
#define DSPIC33_ECAN_CTRL1_ABAT_Access "w1s"
static inline uint16_t dspic33_ecan_ctrl1_abat_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_ABAT_Msk) >> DSPIC33_ECAN_CTRL1_ABAT_Pos);
}
/* REQOP: Requested operating mode. Wait until OPMODE shows the same value. Access rw.
 * Register 4-23 p.30; §7.0 p.42
 */
#define DSPIC33_ECAN_CTRL1_REQOP_Pos 8U
#define DSPIC33_ECAN_CTRL1_REQOP_Msk 0x0700U
#define DSPIC33_ECAN_CTRL1_REQOP_Width 3U
#define DSPIC33_ECAN_CTRL1_REQOP_Access "rw"
#define DSPIC33_ECAN_CTRL1_REQOP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CTRL1_REQOP_Pos) & DSPIC33_ECAN_CTRL1_REQOP_Msk))
static inline uint16_t dspic33_ecan_ctrl1_reqop_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_REQOP_Msk) >> DSPIC33_ECAN_CTRL1_REQOP_Pos);
}
static inline uint16_t dspic33_ecan_ctrl1_reqop_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CTRL1_REQOP_Msk) | DSPIC33_ECAN_CTRL1_REQOP_SET(value));
}
/* OPMODE: Operating mode the module is in. Access ro.
 * Contradictions of the manual: disable_mode_wake_up.
 * Register 4-23 p.30; §7.0 p.42
 */
#define DSPIC33_ECAN_CTRL1_OPMODE_Pos 5U
#define DSPIC33_ECAN_CTRL1_OPMODE_Msk 0x00E0U
#define DSPIC33_ECAN_CTRL1_OPMODE_Width 3U
#define DSPIC33_ECAN_CTRL1_OPMODE_Access "ro"
static inline uint16_t dspic33_ecan_ctrl1_opmode_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_OPMODE_Msk) >> DSPIC33_ECAN_CTRL1_OPMODE_Pos);
}
/* CANCAP: Time stamping. With 1 the module pulses input capture IC2 for one bit time right after the end of
 * frame of every accepted valid message; the IC2 pin cannot be used for anything else then. Access rw.
 * Register 4-23 p.30; §14.0 p.72
 */
#define DSPIC33_ECAN_CTRL1_CANCAP_Pos 3U
#define DSPIC33_ECAN_CTRL1_CANCAP_Msk 0x0008U
#define DSPIC33_ECAN_CTRL1_CANCAP_Width 1U
#define DSPIC33_ECAN_CTRL1_CANCAP_Access "rw"
#define DSPIC33_ECAN_CTRL1_CANCAP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CTRL1_CANCAP_Pos) & DSPIC33_ECAN_CTRL1_CANCAP_Msk))
static inline uint16_t dspic33_ecan_ctrl1_cancap_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_CANCAP_Msk) >> DSPIC33_ECAN_CTRL1_CANCAP_Pos);
}
static inline uint16_t dspic33_ecan_ctrl1_cancap_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CTRL1_CANCAP_Msk) | DSPIC33_ECAN_CTRL1_CANCAP_SET(value));
}
/* WIN: Selects which set of registers lies behind the offsets 0x20 to 0x7F. Access rw.
 * Register 4-23 p.30; external: linker_mc710 (shared addresses)
 */
#define DSPIC33_ECAN_CTRL1_WIN_Pos 0U
#define DSPIC33_ECAN_CTRL1_WIN_Msk 0x0001U
#define DSPIC33_ECAN_CTRL1_WIN_Width 1U
#define DSPIC33_ECAN_CTRL1_WIN_Access "rw"
#define DSPIC33_ECAN_CTRL1_WIN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CTRL1_WIN_Pos) & DSPIC33_ECAN_CTRL1_WIN_Msk))
static inline uint16_t dspic33_ecan_ctrl1_win_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL1_WIN_Msk) >> DSPIC33_ECAN_CTRL1_WIN_Pos);
}
static inline uint16_t dspic33_ecan_ctrl1_win_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CTRL1_WIN_Msk) | DSPIC33_ECAN_CTRL1_WIN_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_ctrl1_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CTRL1;
    value = (uint16_t)((value & (uint16_t)~0x10E0U) | 0x0000U);
    regs->CTRL1 = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* CTRL2: CAN Control Register 2.
 * DeviceNet filtering.
 * Register 4-24 p.31; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_CTRL2_OFFSET 0x002U
#define DSPIC33_ECAN_CTRL2_RESET 0x0000U
#define DSPIC33_ECAN_CTRL2_RESET_MASK 0xFFFFU
/* DNCNT: Number of data bits that are compared with the filter's extended identifier, most significant bit of
 * byte 0 with EID[17] first. Works only for standard messages, with EXIDE = 0 in the filter and MIDE = 1 in its
 * mask. A message with fewer data bits is compared as far as its data go. Access rw. May be programmed with 0 to
 * 18.
 * Contradictions of the manual: dncnt_above_18, devicenet_notation.
 * Register 4-24 p.31; §9.5 p.61; §9.5.2 p.62; Table 9-5 p.62
 */
#define DSPIC33_ECAN_CTRL2_DNCNT_Pos 0U
#define DSPIC33_ECAN_CTRL2_DNCNT_Msk 0x001FU
#define DSPIC33_ECAN_CTRL2_DNCNT_Width 5U
#define DSPIC33_ECAN_CTRL2_DNCNT_Access "rw"
#define DSPIC33_ECAN_CTRL2_DNCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CTRL2_DNCNT_Pos) & DSPIC33_ECAN_CTRL2_DNCNT_Msk))
static inline uint16_t dspic33_ecan_ctrl2_dncnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CTRL2_DNCNT_Msk) >> DSPIC33_ECAN_CTRL2_DNCNT_Pos);
}
static inline uint16_t dspic33_ecan_ctrl2_dncnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 18U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CTRL2_DNCNT_Msk) | DSPIC33_ECAN_CTRL2_DNCNT_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_ctrl2_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CTRL2;
    regs->CTRL2 = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* VEC: CAN Interrupt Code Register.
 * Interrupt cause in a form that can index a jump table. The register's page is missing from the cited copy;
 * fields and positions are those of the register maps and of the device header.
 * Contradictions of the manual: lost_vec_page.
 * Table 3-1 p.9; §12.3 p.69; Register 4-22 p.29; external: header_mc710 (bit positions); external: linker_mc710
 * (offset)
 */
#define DSPIC33_ECAN_VEC_OFFSET 0x004U
#define DSPIC33_ECAN_VEC_RESET 0x0000U
#define DSPIC33_ECAN_VEC_RESET_MASK 0xE080U
/* FILHIT: Number of the filter that a message hit, 0 to 15. The manual explains the field only in word 7 of the
 * message buffer; which message it belongs to here is not said. Access ro.
 * Contradictions of the manual: lost_vec_page.
 * Table 3-1 p.9; §5.0 Buffer 5-8 p.37
 */
#define DSPIC33_ECAN_VEC_FILHIT_Pos 8U
#define DSPIC33_ECAN_VEC_FILHIT_Msk 0x1F00U
#define DSPIC33_ECAN_VEC_FILHIT_Width 5U
#define DSPIC33_ECAN_VEC_FILHIT_Access "ro"
static inline uint16_t dspic33_ecan_vec_filhit_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_VEC_FILHIT_Msk) >> DSPIC33_ECAN_VEC_FILHIT_Pos);
}
/* ICODE: Code of the highest-priority interrupt condition whose flag and enable are both set. For transmit and
 * receive interrupts it is the number of the buffer. Access ro.
 * Contradictions of the manual: lost_vec_page.
 * §12.3.2 p.69; external: driver_icode (codes)
 */
#define DSPIC33_ECAN_VEC_ICODE_Pos 0U
#define DSPIC33_ECAN_VEC_ICODE_Msk 0x007FU
#define DSPIC33_ECAN_VEC_ICODE_Width 7U
#define DSPIC33_ECAN_VEC_ICODE_Access "ro"
static inline uint16_t dspic33_ecan_vec_icode_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_VEC_ICODE_Msk) >> DSPIC33_ECAN_VEC_ICODE_Pos);
}

/* FCTRL: CAN FIFO Control Register.
 * Number of message buffers and start of the receive FIFO. The FIFO ends with the last buffer. The register's
 * page is missing from the cited copy; fields and positions are restored from the text.
 * Hazard: A FIFO that includes a transmit buffer loses every message meant for that buffer.
 * Hazard: FSA must not be larger than the number of buffers minus one; otherwise FNRB counts past the end of the
 * buffers.
 * Hazard: On some PIC24H silicon received data can land in the wrong buffer with peripheral indirect DMA (errata
 * DS80000441J, item 17).
 * A write is dangerous: The receive DMA channel writes 16 bytes at DMAxSTA plus 16 times the buffer number. The
 * memory set aside there must hold the number of buffers that DMABS gives and every buffer that a filter points
 * at; otherwise received messages overwrite other data.
 * Contradictions of the manual: lost_fctrl_page.
 * Table 3-1 p.9; §9.3 p.57; Register 4-18 p.25; external: header_mc710 (bit positions); external: faq_665
 * (hazard); external: errata_pic24hj (hazard); external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_FCTRL_OFFSET 0x006U
#define DSPIC33_ECAN_FCTRL_RESET 0x0000U
#define DSPIC33_ECAN_FCTRL_RESET_MASK 0x1FE0U
/* DMABS: Number of message buffers in DMA RAM. The last of them is the end of the FIFO. Access rw.
 * Contradictions of the manual: lost_fctrl_page.
 * §9.2 p.55; §9.3 p.57
 */
#define DSPIC33_ECAN_FCTRL_DMABS_Pos 13U
#define DSPIC33_ECAN_FCTRL_DMABS_Msk 0xE000U
#define DSPIC33_ECAN_FCTRL_DMABS_Width 3U
#define DSPIC33_ECAN_FCTRL_DMABS_Access "rw"
#define DSPIC33_ECAN_FCTRL_DMABS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_FCTRL_DMABS_Pos) & DSPIC33_ECAN_FCTRL_DMABS_Msk))
static inline uint16_t dspic33_ecan_fctrl_dmabs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_FCTRL_DMABS_Msk) >> DSPIC33_ECAN_FCTRL_DMABS_Pos);
}
static inline uint16_t dspic33_ecan_fctrl_dmabs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_FCTRL_DMABS_Msk) | DSPIC33_ECAN_FCTRL_DMABS_SET(value));
}
/* FSA: Number of the message buffer at which the FIFO starts. Access rw.
 * Contradictions of the manual: lost_fctrl_page.
 * §9.3 p.57
 */
#define DSPIC33_ECAN_FCTRL_FSA_Pos 0U
#define DSPIC33_ECAN_FCTRL_FSA_Msk 0x001FU
#define DSPIC33_ECAN_FCTRL_FSA_Width 5U
#define DSPIC33_ECAN_FCTRL_FSA_Access "rw"
#define DSPIC33_ECAN_FCTRL_FSA_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_FCTRL_FSA_Pos) & DSPIC33_ECAN_FCTRL_FSA_Msk))
static inline uint16_t dspic33_ecan_fctrl_fsa_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_FCTRL_FSA_Msk) >> DSPIC33_ECAN_FCTRL_FSA_Pos);
}
static inline uint16_t dspic33_ecan_fctrl_fsa_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_FCTRL_FSA_Msk) | DSPIC33_ECAN_FCTRL_FSA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_fctrl_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->FCTRL;
    regs->FCTRL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FIFO: CAN FIFO Status Register.
 * Write and read pointer of the receive FIFO, as buffer numbers.
 * Hazard: FNRB equal to FBP means empty or full; only RXFUL tells which.
 * Hazard: FNRB follows the RXFUL bit that was cleared last, so buffers must be released in order.
 * Hazard: FNRB is reported wrong when transmission and reception share one DMA channel (Microchip FAQ 3019).
 * Register 4-19 p.26; §9.3.1 p.58; external: faq_3019 (hazard); external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_FIFO_OFFSET 0x008U
#define DSPIC33_ECAN_FIFO_RESET 0x0000U
#define DSPIC33_ECAN_FIFO_RESET_MASK 0xFFFFU
/* FBP: Buffer that the next FIFO message is written to. Advances with every message stored and with every
 * message lost, and returns to FSA behind the last buffer. Access ro.
 * Contradictions of the manual: fifo_case_1.
 */
#define DSPIC33_ECAN_FIFO_FBP_Pos 8U
#define DSPIC33_ECAN_FIFO_FBP_Msk 0x3F00U
#define DSPIC33_ECAN_FIFO_FBP_Width 6U
#define DSPIC33_ECAN_FIFO_FBP_Access "ro"
static inline uint16_t dspic33_ecan_fifo_fbp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_FIFO_FBP_Msk) >> DSPIC33_ECAN_FIFO_FBP_Pos);
}
/* FNRB: Buffer that software should read next. When an RXFUL bit is cleared the module writes the number of that
 * buffer plus one. Shifted left by four it is the byte offset of the buffer. Access ro.
 * Contradictions of the manual: fifo_case_1.
 */
#define DSPIC33_ECAN_FIFO_FNRB_Pos 0U
#define DSPIC33_ECAN_FIFO_FNRB_Msk 0x003FU
#define DSPIC33_ECAN_FIFO_FNRB_Width 6U
#define DSPIC33_ECAN_FIFO_FNRB_Access "ro"
static inline uint16_t dspic33_ecan_fifo_fnrb_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_FIFO_FNRB_Msk) >> DSPIC33_ECAN_FIFO_FNRB_Pos);
}

/* INTF: CAN Interrupt Flag Register.
 * Event flags in the low byte, error state in the high byte. The register's page is missing from the cited copy;
 * the bits are restored from the register maps and from the sections on errors and interrupts.
 * Hazard: Clear a flag with one store of the complement of its bit. A read-modify-write also clears a flag that
 * rose between the read and the write.
 * Hazard: Clearing ERRIF leaves the error state bits as they are.
 * Hazard: On some PIC24H silicon WAKIF cannot be cleared after a wake-up from Sleep (errata DS80000441J, item
 * 16).
 * Contradictions of the manual: lost_intf_page.
 * Table 3-1 p.9; Table 3-4 p.12; §12.3 p.69; Register 4-20 p.27; external: header_mc710 (bit positions);
 * external: errata_pic24hj (WAKIF hazard); external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_INTF_OFFSET 0x00AU
#define DSPIC33_ECAN_INTF_RESET 0x0000U
#define DSPIC33_ECAN_INTF_RESET_MASK 0xC010U
/* TXBO: Transmitter is bus off. Set when the transmit error counter reaches 256. Access ro.
 * §11.2.3 p.68
 */
#define DSPIC33_ECAN_INTF_TXBO_Pos 13U
#define DSPIC33_ECAN_INTF_TXBO_Msk 0x2000U
#define DSPIC33_ECAN_INTF_TXBO_Width 1U
#define DSPIC33_ECAN_INTF_TXBO_Access "ro"
static inline uint16_t dspic33_ecan_intf_txbo_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_TXBO_Msk) >> DSPIC33_ECAN_INTF_TXBO_Pos);
}
/* TXBP: Transmitter is error passive, that is, the transmit error counter is 128 or more. Hardware clears it
 * below 128. Access ro.
 * Contradictions of the manual: error_passive_limit, error_active_limit.
 * §11.2.1 p.68
 */
#define DSPIC33_ECAN_INTF_TXBP_Pos 12U
#define DSPIC33_ECAN_INTF_TXBP_Msk 0x1000U
#define DSPIC33_ECAN_INTF_TXBP_Width 1U
#define DSPIC33_ECAN_INTF_TXBP_Access "ro"
static inline uint16_t dspic33_ecan_intf_txbp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_TXBP_Msk) >> DSPIC33_ECAN_INTF_TXBP_Pos);
}
/* RXBP: Receiver is error passive, that is, the receive error counter is 128 or more. Hardware clears it below
 * 128. Access ro.
 * Contradictions of the manual: error_passive_limit, error_active_limit.
 * §11.2.2 p.68
 */
#define DSPIC33_ECAN_INTF_RXBP_Pos 11U
#define DSPIC33_ECAN_INTF_RXBP_Msk 0x0800U
#define DSPIC33_ECAN_INTF_RXBP_Width 1U
#define DSPIC33_ECAN_INTF_RXBP_Access "ro"
static inline uint16_t dspic33_ecan_intf_rxbp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_RXBP_Msk) >> DSPIC33_ECAN_INTF_RXBP_Pos);
}
/* TXWAR: Transmitter warning. The transmit error counter is between 96 and 127. Hardware clears it outside that
 * range. Access ro.
 * §11.2.4 p.68
 */
#define DSPIC33_ECAN_INTF_TXWAR_Pos 10U
#define DSPIC33_ECAN_INTF_TXWAR_Msk 0x0400U
#define DSPIC33_ECAN_INTF_TXWAR_Width 1U
#define DSPIC33_ECAN_INTF_TXWAR_Access "ro"
static inline uint16_t dspic33_ecan_intf_txwar_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_TXWAR_Msk) >> DSPIC33_ECAN_INTF_TXWAR_Pos);
}
/* RXWAR: Receiver warning. The receive error counter is between 96 and 127. Hardware clears it outside that
 * range. Access ro.
 * Contradictions of the manual: warning_counters.
 * §11.2.5 p.68
 */
#define DSPIC33_ECAN_INTF_RXWAR_Pos 9U
#define DSPIC33_ECAN_INTF_RXWAR_Msk 0x0200U
#define DSPIC33_ECAN_INTF_RXWAR_Width 1U
#define DSPIC33_ECAN_INTF_RXWAR_Access "ro"
static inline uint16_t dspic33_ecan_intf_rxwar_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_RXWAR_Msk) >> DSPIC33_ECAN_INTF_RXWAR_Pos);
}
/* EWARN: At least one error counter is 96 or more. It is a state only and raises no interrupt. Access ro.
 * Contradictions of the manual: warning_counters.
 * §11.2.5 p.68
 */
#define DSPIC33_ECAN_INTF_EWARN_Pos 8U
#define DSPIC33_ECAN_INTF_EWARN_Msk 0x0100U
#define DSPIC33_ECAN_INTF_EWARN_Width 1U
#define DSPIC33_ECAN_INTF_EWARN_Access "ro"
static inline uint16_t dspic33_ecan_intf_ewarn_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_EWARN_Msk) >> DSPIC33_ECAN_INTF_EWARN_Pos);
}
/* IVRIF: Invalid message. The condition that sets it stands on a missing page. Access w0c. A flag: writing 0
 * clears it, writing 1 does nothing.
 * Contradictions of the manual: lost_interrupt_page.
 * Table 3-1 p.9; Figure 12-1 p.71
 */
#define DSPIC33_ECAN_INTF_IVRIF_Pos 7U
#define DSPIC33_ECAN_INTF_IVRIF_Msk 0x0080U
#define DSPIC33_ECAN_INTF_IVRIF_Width 1U
#define DSPIC33_ECAN_INTF_IVRIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_ivrif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_IVRIF_Msk) >> DSPIC33_ECAN_INTF_IVRIF_Pos);
}
/* WAKIF: Bus activity while the device was in Sleep. Access w0c. A flag: writing 0 clears it, writing 1 does
 * nothing.
 * Contradictions of the manual: lost_interrupt_page, disable_mode_wake_up.
 * Table 3-1 p.9; §13.3 p.72
 */
#define DSPIC33_ECAN_INTF_WAKIF_Pos 6U
#define DSPIC33_ECAN_INTF_WAKIF_Msk 0x0040U
#define DSPIC33_ECAN_INTF_WAKIF_Width 1U
#define DSPIC33_ECAN_INTF_WAKIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_wakif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_WAKIF_Msk) >> DSPIC33_ECAN_INTF_WAKIF_Pos);
}
/* ERRIF: Error. Set on entry into transmitter or receiver warning, transmitter or receiver error passive, and
 * transmitter bus off. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: lost_interrupt_page.
 * §12.3 p.69; §11.2.1 p.68
 */
#define DSPIC33_ECAN_INTF_ERRIF_Pos 5U
#define DSPIC33_ECAN_INTF_ERRIF_Msk 0x0020U
#define DSPIC33_ECAN_INTF_ERRIF_Width 1U
#define DSPIC33_ECAN_INTF_ERRIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_errif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_ERRIF_Msk) >> DSPIC33_ECAN_INTF_ERRIF_Pos);
}
/* FIFOIF: FIFO almost full. Checked when a FIFO buffer has been stored and FBP has advanced; set if FNRB minus
 * FBP is 1, or if FNRB is at the start and FBP at the end of the FIFO. Access w0c. A flag: writing 0 clears it,
 * writing 1 does nothing.
 * Contradictions of the manual: lost_interrupt_page.
 * Equation 9-4 p.58; Table 3-1 p.9
 */
#define DSPIC33_ECAN_INTF_FIFOIF_Pos 3U
#define DSPIC33_ECAN_INTF_FIFOIF_Msk 0x0008U
#define DSPIC33_ECAN_INTF_FIFOIF_Width 1U
#define DSPIC33_ECAN_INTF_FIFOIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_fifoif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_FIFOIF_Msk) >> DSPIC33_ECAN_INTF_FIFOIF_Pos);
}
/* RBOVIF: Receive buffer overflow. A message hit a filter, but its buffer was full, so the message was lost.
 * Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: lost_interrupt_page.
 * §9.2.5 p.57
 */
#define DSPIC33_ECAN_INTF_RBOVIF_Pos 2U
#define DSPIC33_ECAN_INTF_RBOVIF_Msk 0x0004U
#define DSPIC33_ECAN_INTF_RBOVIF_Width 1U
#define DSPIC33_ECAN_INTF_RBOVIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_rbovif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_RBOVIF_Msk) >> DSPIC33_ECAN_INTF_RBOVIF_Pos);
}
/* RBIF: A message was received. Set after the RXFUL bit of the buffer. Access w0c. A flag: writing 0 clears it,
 * writing 1 does nothing.
 * §9.2.5 p.57; §12.3.2 p.69
 */
#define DSPIC33_ECAN_INTF_RBIF_Pos 1U
#define DSPIC33_ECAN_INTF_RBIF_Msk 0x0002U
#define DSPIC33_ECAN_INTF_RBIF_Width 1U
#define DSPIC33_ECAN_INTF_RBIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_rbif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_RBIF_Msk) >> DSPIC33_ECAN_INTF_RBIF_Pos);
}
/* TBIF: A message from one of the buffers 0 to 7 was transmitted. Access w0c. A flag: writing 0 clears it,
 * writing 1 does nothing.
 * §12.3.1 p.69
 */
#define DSPIC33_ECAN_INTF_TBIF_Pos 0U
#define DSPIC33_ECAN_INTF_TBIF_Msk 0x0001U
#define DSPIC33_ECAN_INTF_TBIF_Width 1U
#define DSPIC33_ECAN_INTF_TBIF_Access "w0c"
static inline uint16_t dspic33_ecan_intf_tbif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTF_TBIF_Msk) >> DSPIC33_ECAN_INTF_TBIF_Pos);
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_ecan_intf_clear(dspic33_ecan_regs_t *regs, uint16_t flags)
{
    regs->INTF = (uint16_t)(0x00EFU & (uint16_t)~flags);
}

/* INTE: CAN Interrupt Enable Register.
 * Enables of the event interrupt sources. The interrupt needs both the flag and its enable.
 * Register 4-21 p.28; §12.3 p.69; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_INTE_OFFSET 0x00CU
#define DSPIC33_ECAN_INTE_RESET 0x0000U
#define DSPIC33_ECAN_INTE_RESET_MASK 0xFFFFU
/* IVRIE: Enables the invalid message interrupt. Access rw. */
#define DSPIC33_ECAN_INTE_IVRIE_Pos 7U
#define DSPIC33_ECAN_INTE_IVRIE_Msk 0x0080U
#define DSPIC33_ECAN_INTE_IVRIE_Width 1U
#define DSPIC33_ECAN_INTE_IVRIE_Access "rw"
#define DSPIC33_ECAN_INTE_IVRIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_IVRIE_Pos) & DSPIC33_ECAN_INTE_IVRIE_Msk))
static inline uint16_t dspic33_ecan_inte_ivrie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_IVRIE_Msk) >> DSPIC33_ECAN_INTE_IVRIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_ivrie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_IVRIE_Msk) | DSPIC33_ECAN_INTE_IVRIE_SET(value));
}
/* WAKIE: Enables the interrupt on bus activity during Sleep. Access rw.
 * Contradictions of the manual: wakie_title.
 */
#define DSPIC33_ECAN_INTE_WAKIE_Pos 6U
#define DSPIC33_ECAN_INTE_WAKIE_Msk 0x0040U
#define DSPIC33_ECAN_INTE_WAKIE_Width 1U
#define DSPIC33_ECAN_INTE_WAKIE_Access "rw"
#define DSPIC33_ECAN_INTE_WAKIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_WAKIE_Pos) & DSPIC33_ECAN_INTE_WAKIE_Msk))
static inline uint16_t dspic33_ecan_inte_wakie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_WAKIE_Msk) >> DSPIC33_ECAN_INTE_WAKIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_wakie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_WAKIE_Msk) | DSPIC33_ECAN_INTE_WAKIE_SET(value));
}
/* ERRIE: Enables the error interrupt. Access rw. */
#define DSPIC33_ECAN_INTE_ERRIE_Pos 5U
#define DSPIC33_ECAN_INTE_ERRIE_Msk 0x0020U
#define DSPIC33_ECAN_INTE_ERRIE_Width 1U
#define DSPIC33_ECAN_INTE_ERRIE_Access "rw"
#define DSPIC33_ECAN_INTE_ERRIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_ERRIE_Pos) & DSPIC33_ECAN_INTE_ERRIE_Msk))
static inline uint16_t dspic33_ecan_inte_errie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_ERRIE_Msk) >> DSPIC33_ECAN_INTE_ERRIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_errie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_ERRIE_Msk) | DSPIC33_ECAN_INTE_ERRIE_SET(value));
}
/* FIFOIE: Enables the interrupt for a FIFO that is almost full. Access rw. */
#define DSPIC33_ECAN_INTE_FIFOIE_Pos 3U
#define DSPIC33_ECAN_INTE_FIFOIE_Msk 0x0008U
#define DSPIC33_ECAN_INTE_FIFOIE_Width 1U
#define DSPIC33_ECAN_INTE_FIFOIE_Access "rw"
#define DSPIC33_ECAN_INTE_FIFOIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_FIFOIE_Pos) & DSPIC33_ECAN_INTE_FIFOIE_Msk))
static inline uint16_t dspic33_ecan_inte_fifoie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_FIFOIE_Msk) >> DSPIC33_ECAN_INTE_FIFOIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_fifoie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_FIFOIE_Msk) | DSPIC33_ECAN_INTE_FIFOIE_SET(value));
}
/* RBOVIE: Enables the receive buffer overflow interrupt. Access rw. */
#define DSPIC33_ECAN_INTE_RBOVIE_Pos 2U
#define DSPIC33_ECAN_INTE_RBOVIE_Msk 0x0004U
#define DSPIC33_ECAN_INTE_RBOVIE_Width 1U
#define DSPIC33_ECAN_INTE_RBOVIE_Access "rw"
#define DSPIC33_ECAN_INTE_RBOVIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_RBOVIE_Pos) & DSPIC33_ECAN_INTE_RBOVIE_Msk))
static inline uint16_t dspic33_ecan_inte_rbovie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_RBOVIE_Msk) >> DSPIC33_ECAN_INTE_RBOVIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_rbovie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_RBOVIE_Msk) | DSPIC33_ECAN_INTE_RBOVIE_SET(value));
}
/* RBIE: Enables the receive buffer interrupt. Access rw. */
#define DSPIC33_ECAN_INTE_RBIE_Pos 1U
#define DSPIC33_ECAN_INTE_RBIE_Msk 0x0002U
#define DSPIC33_ECAN_INTE_RBIE_Width 1U
#define DSPIC33_ECAN_INTE_RBIE_Access "rw"
#define DSPIC33_ECAN_INTE_RBIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_RBIE_Pos) & DSPIC33_ECAN_INTE_RBIE_Msk))
static inline uint16_t dspic33_ecan_inte_rbie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_RBIE_Msk) >> DSPIC33_ECAN_INTE_RBIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_rbie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_RBIE_Msk) | DSPIC33_ECAN_INTE_RBIE_SET(value));
}
/* TBIE: Enables the transmit buffer interrupt. Access rw. */
#define DSPIC33_ECAN_INTE_TBIE_Pos 0U
#define DSPIC33_ECAN_INTE_TBIE_Msk 0x0001U
#define DSPIC33_ECAN_INTE_TBIE_Width 1U
#define DSPIC33_ECAN_INTE_TBIE_Access "rw"
#define DSPIC33_ECAN_INTE_TBIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_INTE_TBIE_Pos) & DSPIC33_ECAN_INTE_TBIE_Msk))
static inline uint16_t dspic33_ecan_inte_tbie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_INTE_TBIE_Msk) >> DSPIC33_ECAN_INTE_TBIE_Pos);
}
static inline uint16_t dspic33_ecan_inte_tbie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_INTE_TBIE_Msk) | DSPIC33_ECAN_INTE_TBIE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_inte_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->INTE;
    regs->INTE = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* EC: CAN Transmit/Receive Error Count Register.
 * Error counters of CAN 2.0B. A hardware reset clears them.
 * Register 4-26 p.33; §11.2 p.66; §7.1 p.42; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_EC_OFFSET 0x00EU
#define DSPIC33_ECAN_EC_RESET 0x0000U
#define DSPIC33_ECAN_EC_RESET_MASK 0xFFFFU
/* TERRCNT: Transmit error counter. Eight bits; bus off begins at 256, which they cannot hold. Access ro. */
#define DSPIC33_ECAN_EC_TERRCNT_Pos 8U
#define DSPIC33_ECAN_EC_TERRCNT_Msk 0xFF00U
#define DSPIC33_ECAN_EC_TERRCNT_Width 8U
#define DSPIC33_ECAN_EC_TERRCNT_Access "ro"
static inline uint16_t dspic33_ecan_ec_terrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_EC_TERRCNT_Msk) >> DSPIC33_ECAN_EC_TERRCNT_Pos);
}
/* RERRCNT: Receive error counter. Access ro. */
#define DSPIC33_ECAN_EC_RERRCNT_Pos 0U
#define DSPIC33_ECAN_EC_RERRCNT_Msk 0x00FFU
#define DSPIC33_ECAN_EC_RERRCNT_Width 8U
#define DSPIC33_ECAN_EC_RERRCNT_Access "ro"
static inline uint16_t dspic33_ecan_ec_rerrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_EC_RERRCNT_Msk) >> DSPIC33_ECAN_EC_RERRCNT_Pos);
}

/* CFG1: CAN Baud Rate Configuration Register 1.
 * Prescaler and synchronization jump width. The register's page is missing from the cited copy; the fields are
 * restored from section 6.0 and the examples.
 * Contradictions of the manual: lost_cfg1_page.
 * Table 3-1 p.9; Figure 6-1 p.38; §6.3 p.39; Register 4-1 p.15; external: header_mc710 (bit positions);
 * external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_CFG1_OFFSET 0x010U
#define DSPIC33_ECAN_CFG1_RESET 0x0000U
#define DSPIC33_ECAN_CFG1_RESET_MASK 0xFF00U
/* SJW: Synchronization jump width, 1 to 4 time quanta. Not longer than phase segment 2. Access rw:configuration.
 * A write has an effect only if configuration (CTRL1.OPMODE == configuration). Means value + 1 tq.
 * Contradictions of the manual: lost_cfg1_page, segment2_and_jump_width, register_name_slips.
 * §6.3 p.39; Example 6-2 p.41
 */
#define DSPIC33_ECAN_CFG1_SJW_Pos 6U
#define DSPIC33_ECAN_CFG1_SJW_Msk 0x00C0U
#define DSPIC33_ECAN_CFG1_SJW_Width 2U
#define DSPIC33_ECAN_CFG1_SJW_Access "rw:configuration"
#define DSPIC33_ECAN_CFG1_SJW_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG1_SJW_Pos) & DSPIC33_ECAN_CFG1_SJW_Msk))
static inline uint16_t dspic33_ecan_cfg1_sjw_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG1_SJW_Msk) >> DSPIC33_ECAN_CFG1_SJW_Pos);
}
static inline uint16_t dspic33_ecan_cfg1_sjw_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG1_SJW_Msk) | DSPIC33_ECAN_CFG1_SJW_SET(value));
}
/* BRP: Baud rate prescaler, 1 to 64. A time quantum lasts 2 × (BRP + 1) instruction cycles of FCY. Access
 * rw:configuration. A write has an effect only if configuration (CTRL1.OPMODE == configuration). Means value + 1
 * FCY/2 periods.
 * Contradictions of the manual: lost_cfg1_page, scrambled_equation_6_1, example_6_2_clock.
 * Figure 6-1 p.38; Equation 6-2 p.40
 */
#define DSPIC33_ECAN_CFG1_BRP_Pos 0U
#define DSPIC33_ECAN_CFG1_BRP_Msk 0x003FU
#define DSPIC33_ECAN_CFG1_BRP_Width 6U
#define DSPIC33_ECAN_CFG1_BRP_Access "rw:configuration"
#define DSPIC33_ECAN_CFG1_BRP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG1_BRP_Pos) & DSPIC33_ECAN_CFG1_BRP_Msk))
static inline uint16_t dspic33_ecan_cfg1_brp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG1_BRP_Msk) >> DSPIC33_ECAN_CFG1_BRP_Pos);
}
static inline uint16_t dspic33_ecan_cfg1_brp_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 63U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG1_BRP_Msk) | DSPIC33_ECAN_CFG1_BRP_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_cfg1_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CFG1;
    regs->CFG1 = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* CFG2: CAN Baud Rate Configuration Register 2.
 * Segments of the bit time, number of samples and wake-up filter.
 * Hazard: WAKFIL can be changed only in Configuration mode, although it is needed just before Sleep, which is
 * entered through Disable mode.
 * Contradictions of the manual: cfg2_reset.
 * Register 4-2 p.16; §7.1 p.42; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_CFG2_OFFSET 0x012U
#define DSPIC33_ECAN_CFG2_RESET 0x0000U
#define DSPIC33_ECAN_CFG2_RESET_MASK 0xB800U
/* WAKFIL: Low-pass filter on CxRX for wake-up. With 1 short glitches on the bus do not wake the device. Access
 * rw:configuration. A write has an effect only if configuration (CTRL1.OPMODE == configuration).
 * Register 4-2 p.16; §13.3 p.72
 */
#define DSPIC33_ECAN_CFG2_WAKFIL_Pos 14U
#define DSPIC33_ECAN_CFG2_WAKFIL_Msk 0x4000U
#define DSPIC33_ECAN_CFG2_WAKFIL_Width 1U
#define DSPIC33_ECAN_CFG2_WAKFIL_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_WAKFIL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_WAKFIL_Pos) & DSPIC33_ECAN_CFG2_WAKFIL_Msk))
static inline uint16_t dspic33_ecan_cfg2_wakfil_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_WAKFIL_Msk) >> DSPIC33_ECAN_CFG2_WAKFIL_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_wakfil_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_WAKFIL_Msk) | DSPIC33_ECAN_CFG2_WAKFIL_SET(value));
}
/* SEG2PH: Phase segment 2, 1 to 8 time quanta. Used as programmed only with SEG2PHTS = 1. Access
 * rw:configuration. A write has an effect only if configuration (CTRL1.OPMODE == configuration). Means value + 1
 * tq.
 * Contradictions of the manual: segment2_and_jump_width.
 */
#define DSPIC33_ECAN_CFG2_SEG2PH_Pos 8U
#define DSPIC33_ECAN_CFG2_SEG2PH_Msk 0x0700U
#define DSPIC33_ECAN_CFG2_SEG2PH_Width 3U
#define DSPIC33_ECAN_CFG2_SEG2PH_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_SEG2PH_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_SEG2PH_Pos) & DSPIC33_ECAN_CFG2_SEG2PH_Msk))
static inline uint16_t dspic33_ecan_cfg2_seg2ph_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_SEG2PH_Msk) >> DSPIC33_ECAN_CFG2_SEG2PH_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_seg2ph_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_SEG2PH_Msk) | DSPIC33_ECAN_CFG2_SEG2PH_SET(value));
}
/* SEG2PHTS: Chooses how long phase segment 2 is. Access rw:configuration. A write has an effect only if
 * configuration (CTRL1.OPMODE == configuration).
 * Contradictions of the manual: segment2_automatic.
 */
#define DSPIC33_ECAN_CFG2_SEG2PHTS_Pos 7U
#define DSPIC33_ECAN_CFG2_SEG2PHTS_Msk 0x0080U
#define DSPIC33_ECAN_CFG2_SEG2PHTS_Width 1U
#define DSPIC33_ECAN_CFG2_SEG2PHTS_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_SEG2PHTS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_SEG2PHTS_Pos) & DSPIC33_ECAN_CFG2_SEG2PHTS_Msk))
static inline uint16_t dspic33_ecan_cfg2_seg2phts_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_SEG2PHTS_Msk) >> DSPIC33_ECAN_CFG2_SEG2PHTS_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_seg2phts_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_SEG2PHTS_Msk) | DSPIC33_ECAN_CFG2_SEG2PHTS_SET(value));
}
/* SAM: Samples per bit. Access rw:configuration. A write has an effect only if configuration (CTRL1.OPMODE ==
 * configuration).
 * Register 4-2 p.16; §6.2 p.39
 */
#define DSPIC33_ECAN_CFG2_SAM_Pos 6U
#define DSPIC33_ECAN_CFG2_SAM_Msk 0x0040U
#define DSPIC33_ECAN_CFG2_SAM_Width 1U
#define DSPIC33_ECAN_CFG2_SAM_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_SAM_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_SAM_Pos) & DSPIC33_ECAN_CFG2_SAM_Msk))
static inline uint16_t dspic33_ecan_cfg2_sam_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_SAM_Msk) >> DSPIC33_ECAN_CFG2_SAM_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_sam_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_SAM_Msk) | DSPIC33_ECAN_CFG2_SAM_SET(value));
}
/* SEG1PH: Phase segment 1, 1 to 8 time quanta. Access rw:configuration. A write has an effect only if
 * configuration (CTRL1.OPMODE == configuration). Means value + 1 tq.
 */
#define DSPIC33_ECAN_CFG2_SEG1PH_Pos 3U
#define DSPIC33_ECAN_CFG2_SEG1PH_Msk 0x0038U
#define DSPIC33_ECAN_CFG2_SEG1PH_Width 3U
#define DSPIC33_ECAN_CFG2_SEG1PH_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_SEG1PH_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_SEG1PH_Pos) & DSPIC33_ECAN_CFG2_SEG1PH_Msk))
static inline uint16_t dspic33_ecan_cfg2_seg1ph_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_SEG1PH_Msk) >> DSPIC33_ECAN_CFG2_SEG1PH_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_seg1ph_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_SEG1PH_Msk) | DSPIC33_ECAN_CFG2_SEG1PH_SET(value));
}
/* PRSEG: Propagation segment, 1 to 8 time quanta. Access rw:configuration. A write has an effect only if
 * configuration (CTRL1.OPMODE == configuration). Means value + 1 tq.
 */
#define DSPIC33_ECAN_CFG2_PRSEG_Pos 0U
#define DSPIC33_ECAN_CFG2_PRSEG_Msk 0x0007U
#define DSPIC33_ECAN_CFG2_PRSEG_Width 3U
#define DSPIC33_ECAN_CFG2_PRSEG_Access "rw:configuration"
#define DSPIC33_ECAN_CFG2_PRSEG_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_CFG2_PRSEG_Pos) & DSPIC33_ECAN_CFG2_PRSEG_Msk))
static inline uint16_t dspic33_ecan_cfg2_prseg_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_CFG2_PRSEG_Msk) >> DSPIC33_ECAN_CFG2_PRSEG_Pos);
}
static inline uint16_t dspic33_ecan_cfg2_prseg_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_CFG2_PRSEG_Msk) | DSPIC33_ECAN_CFG2_PRSEG_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_cfg2_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CFG2;
    regs->CFG2 = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FEN1: CAN Acceptance Filter Enable Register.
 * Enables of the acceptance filters.
 * Hazard: After reset all 16 filters are enabled while filters and masks are unknown and all of them point to
 * buffer 0 with mask 0; define or disable every filter before leaving Configuration mode.
 * Register 4-3 p.17; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_FEN1_OFFSET 0x014U
#define DSPIC33_ECAN_FEN1_RESET 0xFFFFU
#define DSPIC33_ECAN_FEN1_RESET_MASK 0xFFFFU
/* FLTEN: Enables the filter of this number. Access rw. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: example_9_2_slips.
 */
#define DSPIC33_ECAN_FEN1_FLTEN_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_ECAN_FEN1_FLTEN_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_ECAN_FEN1_FLTEN_Lanes 16U
#define DSPIC33_ECAN_FEN1_FLTEN_Width 1U
#define DSPIC33_ECAN_FEN1_FLTEN_Access "rw"
#define DSPIC33_ECAN_FEN1_FLTEN_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_FEN1_FLTEN_Pos(lane)) & DSPIC33_ECAN_FEN1_FLTEN_Msk(lane)))
static inline uint16_t dspic33_ecan_fen1_flten_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_ECAN_FEN1_FLTEN_Msk(lane)) >> DSPIC33_ECAN_FEN1_FLTEN_Pos(lane));
}
static inline uint16_t dspic33_ecan_fen1_flten_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 16U);
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_FEN1_FLTEN_Msk(lane)) | DSPIC33_ECAN_FEN1_FLTEN_SET(lane, value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_fen1_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->FEN1;
    regs->FEN1 = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FMSKSEL: CAN Filter Mask Selection Register.
 * Mask of each filter. The first register serves filters 0 to 7, the second filters 8 to 15.
 * Register 4-8 p.19; Register 4-9 p.20; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_FMSK_SEL_OFFSET 0x018U
#define DSPIC33_ECAN_FMSK_SEL_COUNT 2U
#define DSPIC33_ECAN_FMSK_SEL_STRIDE 0x002U
#define DSPIC33_ECAN_FMSK_SEL_FIRST 1U
#define DSPIC33_ECAN_FMSK_SEL_RESET 0x0000U
#define DSPIC33_ECAN_FMSK_SEL_RESET_MASK 0xFFFFU
/* FnMSK: Mask that the filter of this number uses. Access rw. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: no_mask_code.
 */
#define DSPIC33_ECAN_FMSK_SEL_FMSK_Pos(lane) (0U + 2U * (lane))
#define DSPIC33_ECAN_FMSK_SEL_FMSK_Msk(lane) ((uint16_t)(0x0003U << (2U * (lane))))
#define DSPIC33_ECAN_FMSK_SEL_FMSK_Lanes 8U
#define DSPIC33_ECAN_FMSK_SEL_FMSK_Width 2U
#define DSPIC33_ECAN_FMSK_SEL_FMSK_Access "rw"
#define DSPIC33_ECAN_FMSK_SEL_FMSK_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_FMSK_SEL_FMSK_Pos(lane)) & DSPIC33_ECAN_FMSK_SEL_FMSK_Msk(lane)))
static inline uint16_t dspic33_ecan_fmsk_sel_fmsk_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 8U);
    return (uint16_t)((reg & DSPIC33_ECAN_FMSK_SEL_FMSK_Msk(lane)) >> DSPIC33_ECAN_FMSK_SEL_FMSK_Pos(lane));
}
static inline uint16_t dspic33_ecan_fmsk_sel_fmsk_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 8U);
    DSPIC33_ECAN_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_FMSK_SEL_FMSK_Msk(lane)) | DSPIC33_ECAN_FMSK_SEL_FMSK_SET(lane, value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_fmsk_sel(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    return &regs->FMSKSEL[n - 1U];
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_fmsk_sel_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    uint16_t value = regs->FMSKSEL[n - 1U];
    regs->FMSKSEL[n - 1U] = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXFUL: CAN Receive Buffer Full Register.
 * One full flag for each message buffer, 0 to 15 in the first and 16 to 31 in the second register.
 * Visible only in the window buffer, while CTRL1.WIN is 0.
 * Hazard: Release a buffer with one store of the complement of its bit. A read-modify-write releases buffers
 * that were filled between the read and the write, and their messages are lost.
 * Hazard: Read the buffer first and clear its flag afterwards. In the FIFO, clearing moves FNRB to the next
 * buffer.
 * Register 4-14 p.22; Register 4-15 p.23; §9.2.5 p.57; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXFUL_OFFSET 0x020U
#define DSPIC33_ECAN_RXFUL_COUNT 2U
#define DSPIC33_ECAN_RXFUL_STRIDE 0x002U
#define DSPIC33_ECAN_RXFUL_FIRST 1U
#define DSPIC33_ECAN_RXFUL_RESET 0x0000U
#define DSPIC33_ECAN_RXFUL_RESET_MASK 0xFFFFU
/* RXFUL: The buffer of this number holds a received message. Set by the module; software writes 0 to release the
 * buffer. Access w0c. A flag: writing 0 clears it, writing 1 does nothing. Lane 0 is number 0 in the first
 * register.
 * Contradictions of the manual: upper_half_numbering.
 */
#define DSPIC33_ECAN_RXFUL_RXFUL_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_ECAN_RXFUL_RXFUL_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_ECAN_RXFUL_RXFUL_Lanes 16U
#define DSPIC33_ECAN_RXFUL_RXFUL_Width 1U
#define DSPIC33_ECAN_RXFUL_RXFUL_Access "w0c"
static inline uint16_t dspic33_ecan_rxful_rxful_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_ECAN_RXFUL_RXFUL_Msk(lane)) >> DSPIC33_ECAN_RXFUL_RXFUL_Pos(lane));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxful(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    return &regs->WINDOW.BUFFER.RXFUL[n - 1U];
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_ecan_rxful_clear(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t flags)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    regs->WINDOW.BUFFER.RXFUL[n - 1U] = (uint16_t)(0xFFFFU & (uint16_t)~flags);
}

/* RXOVF: CAN Receive Buffer Overflow Register.
 * One overflow flag for each message buffer, 0 to 15 in the first and 16 to 31 in the second register.
 * Visible only in the window buffer, while CTRL1.WIN is 0.
 * Hazard: Clear a flag with one store of the complement of its bit; a read-modify-write loses flags that rise in
 * between.
 * Register 4-16 p.23; Register 4-17 p.24; §9.2.5 p.57; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXOVF_OFFSET 0x028U
#define DSPIC33_ECAN_RXOVF_COUNT 2U
#define DSPIC33_ECAN_RXOVF_STRIDE 0x002U
#define DSPIC33_ECAN_RXOVF_FIRST 1U
#define DSPIC33_ECAN_RXOVF_RESET 0x0000U
#define DSPIC33_ECAN_RXOVF_RESET_MASK 0xFFFFU
/* RXOVF: A message was meant for this buffer while it was full, or while it was a transmit buffer in the FIFO
 * area, and was lost. The old content is kept. If several filters match and all their buffers are full, the
 * buffer of the lowest-numbered filter is marked. Access w0c. A flag: writing 0 clears it, writing 1 does
 * nothing. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: rxovf_name, upper_half_numbering.
 */
#define DSPIC33_ECAN_RXOVF_RXOVF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_ECAN_RXOVF_RXOVF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_ECAN_RXOVF_RXOVF_Lanes 16U
#define DSPIC33_ECAN_RXOVF_RXOVF_Width 1U
#define DSPIC33_ECAN_RXOVF_RXOVF_Access "w0c"
static inline uint16_t dspic33_ecan_rxovf_rxovf_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_ECAN_RXOVF_RXOVF_Msk(lane)) >> DSPIC33_ECAN_RXOVF_RXOVF_Pos(lane));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxovf(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    return &regs->WINDOW.BUFFER.RXOVF[n - 1U];
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_ecan_rxovf_clear(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t flags)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 2U);
    regs->WINDOW.BUFFER.RXOVF[n - 1U] = (uint16_t)(0xFFFFU & (uint16_t)~flags);
}

/* TRCON: CAN TX/RX Buffer Control Register.
 * Control of two of the buffers 0 to 7, the even one in the low byte and the odd one in the high byte. The
 * register's page is missing from the cited copy; the bits are restored from the register maps and section 8.
 * Visible only in the window buffer, while CTRL1.WIN is 0.
 * Hazard: Two buffers share one register and hardware changes both TXREQ bits. A read-modify-write for one
 * buffer can send the other buffer's message a second time, or abort one that has just been requested.
 * Hazard: Never set TXREQ of a buffer with TXEN = 0; the manual calls the result unpredictable.
 * Hazard: Write the message to DMA RAM before TXREQ is set.
 * Contradictions of the manual: lost_trmncon_page.
 * Table 3-2 p.9; Table 3-5 p.12; §8.1 p.43; Register 4-25 p.32; external: header_mc710 (bit positions);
 * external: frm_dspic30f (access and meaning of TXABT); external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_TR_CON_OFFSET 0x030U
#define DSPIC33_ECAN_TR_CON_COUNT 4U
#define DSPIC33_ECAN_TR_CON_STRIDE 0x002U
#define DSPIC33_ECAN_TR_CON_FIRST 0U
#define DSPIC33_ECAN_TR_CON_RESET 0x0000U
#define DSPIC33_ECAN_TR_CON_RESET_MASK 0x0000U
/* TXEN: Use of the buffer. Access rw. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: txen_position, example_8_3_names.
 * §8.0 p.43; §9.2.2 p.56
 */
#define DSPIC33_ECAN_TR_CON_TXEN_Pos(lane) (7U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXEN_Msk(lane) ((uint16_t)(0x0080U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXEN_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXEN_Width 1U
#define DSPIC33_ECAN_TR_CON_TXEN_Access "rw"
#define DSPIC33_ECAN_TR_CON_TXEN_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TR_CON_TXEN_Pos(lane)) & DSPIC33_ECAN_TR_CON_TXEN_Msk(lane)))
static inline uint16_t dspic33_ecan_tr_con_txen_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXEN_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXEN_Pos(lane));
}
static inline uint16_t dspic33_ecan_tr_con_txen_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TR_CON_TXEN_Msk(lane)) | DSPIC33_ECAN_TR_CON_TXEN_SET(lane, value));
}
/* TXABT: The message was aborted. Cleared when TXREQ is set again. Access ro. Lane 0 is number 0 in the first
 * register.
 * Contradictions of the manual: txabt_name.
 * Table 3-2 p.9; external: frm_dspic30f (meaning)
 */
#define DSPIC33_ECAN_TR_CON_TXABT_Pos(lane) (6U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXABT_Msk(lane) ((uint16_t)(0x0040U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXABT_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXABT_Width 1U
#define DSPIC33_ECAN_TR_CON_TXABT_Access "ro"
static inline uint16_t dspic33_ecan_tr_con_txabt_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXABT_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXABT_Pos(lane));
}
/* TXLARB: The message lost arbitration. The bit stays set when the message is sent later and is cleared when
 * TXREQ is set again. Access ro. Lane 0 is number 0 in the first register.
 * §8.1 p.43; Table 8-1 p.43
 */
#define DSPIC33_ECAN_TR_CON_TXLARB_Pos(lane) (5U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXLARB_Msk(lane) ((uint16_t)(0x0020U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXLARB_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXLARB_Width 1U
#define DSPIC33_ECAN_TR_CON_TXLARB_Access "ro"
static inline uint16_t dspic33_ecan_tr_con_txlarb_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXLARB_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXLARB_Pos(lane));
}
/* TXERR: A bus error occurred while the message was being sent. Cleared when TXREQ is set again. Access ro. Lane
 * 0 is number 0 in the first register.
 * §8.1 p.43; external: frm_dspic30f (clearing)
 */
#define DSPIC33_ECAN_TR_CON_TXERR_Pos(lane) (4U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXERR_Msk(lane) ((uint16_t)(0x0010U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXERR_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXERR_Width 1U
#define DSPIC33_ECAN_TR_CON_TXERR_Access "ro"
static inline uint16_t dspic33_ecan_tr_con_txerr_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXERR_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXERR_Pos(lane));
}
/* TXREQ: Writing 1 requests transmission; hardware clears the bit when the message has been sent. Writing 0 asks
 * for an abort. With RTREN = 1 hardware also sets the bit when a matching remote frame arrives. Access rwhc. A
 * request that can be withdrawn: 1 requests, 0 aborts, hardware clears it. Lane 0 is number 0 in the first
 * register.
 * §8.1 p.43; §8.2 p.47; Figure 8-2 p.48
 */
#define DSPIC33_ECAN_TR_CON_TXREQ_Pos(lane) (3U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXREQ_Msk(lane) ((uint16_t)(0x0008U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXREQ_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXREQ_Width 1U
#define DSPIC33_ECAN_TR_CON_TXREQ_Access "rwhc"
#define DSPIC33_ECAN_TR_CON_TXREQ_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TR_CON_TXREQ_Pos(lane)) & DSPIC33_ECAN_TR_CON_TXREQ_Msk(lane)))
static inline uint16_t dspic33_ecan_tr_con_txreq_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXREQ_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXREQ_Pos(lane));
}
/* RTREN: Automatic answer. With 1 in a transmit buffer, a remote frame that hits a filter pointing here sets
 * TXREQ and is not stored; the buffer's own DLC and data are sent. Access rw. Lane 0 is number 0 in the first
 * register.
 * §8.3.2 p.47; §9.2.2 p.56
 */
#define DSPIC33_ECAN_TR_CON_RTREN_Pos(lane) (2U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_RTREN_Msk(lane) ((uint16_t)(0x0004U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_RTREN_Lanes 2U
#define DSPIC33_ECAN_TR_CON_RTREN_Width 1U
#define DSPIC33_ECAN_TR_CON_RTREN_Access "rw"
#define DSPIC33_ECAN_TR_CON_RTREN_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TR_CON_RTREN_Pos(lane)) & DSPIC33_ECAN_TR_CON_RTREN_Msk(lane)))
static inline uint16_t dspic33_ecan_tr_con_rtren_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_RTREN_Msk(lane)) >> DSPIC33_ECAN_TR_CON_RTREN_Pos(lane));
}
static inline uint16_t dspic33_ecan_tr_con_rtren_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TR_CON_RTREN_Msk(lane)) | DSPIC33_ECAN_TR_CON_RTREN_SET(lane, value));
}
/* TXnPRI: Priority of the buffer against the other transmit buffers that are ready. The identifier plays no
 * part. Access rw. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: example_8_3_names.
 * §8.1 p.43
 */
#define DSPIC33_ECAN_TR_CON_TXPRI_Pos(lane) (0U + 8U * (lane))
#define DSPIC33_ECAN_TR_CON_TXPRI_Msk(lane) ((uint16_t)(0x0003U << (8U * (lane))))
#define DSPIC33_ECAN_TR_CON_TXPRI_Lanes 2U
#define DSPIC33_ECAN_TR_CON_TXPRI_Width 2U
#define DSPIC33_ECAN_TR_CON_TXPRI_Access "rw"
#define DSPIC33_ECAN_TR_CON_TXPRI_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TR_CON_TXPRI_Pos(lane)) & DSPIC33_ECAN_TR_CON_TXPRI_Msk(lane)))
static inline uint16_t dspic33_ecan_tr_con_txpri_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_ECAN_TR_CON_TXPRI_Msk(lane)) >> DSPIC33_ECAN_TR_CON_TXPRI_Pos(lane));
}
static inline uint16_t dspic33_ecan_tr_con_txpri_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 2U);
    DSPIC33_ECAN_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TR_CON_TXPRI_Msk(lane)) | DSPIC33_ECAN_TR_CON_TXPRI_SET(lane, value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_tr_con(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 4U);
    return &regs->WINDOW.BUFFER.TRCON[n];
}
/* No read-modify-write: no value written to TXREQ leaves it alone. Compose the whole value and store it. */

/* RXD: CAN Receive Data Register.
 * Word of a received message. Meant for the DMA channel of the CxRX request.
 * Visible only in the window buffer, while CTRL1.WIN is 0.
 * Hazard: Leave the register to the DMA channel. What an access by the CPU does is not said.
 * Contradictions of the manual: rxd_txd_reset.
 * Register 4-27 p.33; §12.2 p.69; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXD_OFFSET 0x040U
#define DSPIC33_ECAN_RXD_RESET 0x0000U
#define DSPIC33_ECAN_RXD_RESET_MASK 0xFFFFU
/* DATA: Received data word. Eight words make one message. Access rw. */
#define DSPIC33_ECAN_RXD_DATA_Pos 0U
#define DSPIC33_ECAN_RXD_DATA_Msk 0xFFFFU
#define DSPIC33_ECAN_RXD_DATA_Width 16U
#define DSPIC33_ECAN_RXD_DATA_Access "rw"
#define DSPIC33_ECAN_RXD_DATA_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXD_DATA_Pos) & DSPIC33_ECAN_RXD_DATA_Msk))
static inline uint16_t dspic33_ecan_rxd_data_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXD_DATA_Msk) >> DSPIC33_ECAN_RXD_DATA_Pos);
}
static inline uint16_t dspic33_ecan_rxd_data_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXD_DATA_Msk) | DSPIC33_ECAN_RXD_DATA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_rxd_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->WINDOW.BUFFER.RXD;
    regs->WINDOW.BUFFER.RXD = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TXD: CAN Transmit Data Register.
 * Word of a message to be sent. Meant for the DMA channel of the CxTX request.
 * Visible only in the window buffer, while CTRL1.WIN is 0.
 * Hazard: Leave the register to the DMA channel. What an access by the CPU does is not said.
 * Contradictions of the manual: rxd_txd_reset.
 * Register 4-28 p.33; §12.1 p.69; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_TXD_OFFSET 0x042U
#define DSPIC33_ECAN_TXD_RESET 0x0000U
#define DSPIC33_ECAN_TXD_RESET_MASK 0xFFFFU
/* DATA: Data word to be sent. Eight words make one message. Access rw. */
#define DSPIC33_ECAN_TXD_DATA_Pos 0U
#define DSPIC33_ECAN_TXD_DATA_Msk 0xFFFFU
#define DSPIC33_ECAN_TXD_DATA_Width 16U
#define DSPIC33_ECAN_TXD_DATA_Access "rw"
#define DSPIC33_ECAN_TXD_DATA_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TXD_DATA_Pos) & DSPIC33_ECAN_TXD_DATA_Msk))
static inline uint16_t dspic33_ecan_txd_data_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TXD_DATA_Msk) >> DSPIC33_ECAN_TXD_DATA_Pos);
}
static inline uint16_t dspic33_ecan_txd_data_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TXD_DATA_Msk) | DSPIC33_ECAN_TXD_DATA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_txd_modify(dspic33_ecan_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->WINDOW.BUFFER.TXD;
    regs->WINDOW.BUFFER.TXD = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* BUFPNT: CAN Filter Buffer Pointer Register.
 * Buffer for the messages of each filter, four filters to a register. If a message matches several filters, the
 * lowest-numbered one that points to an empty buffer takes it.
 * Visible only in the window filter, while CTRL1.WIN is 1.
 * Hazard: The memory behind DMAxSTA must hold every buffer that a filter points at; see CxFCTRL.
 * Hazard: Code 15 is the FIFO. Message buffers 15 to 31 can be filled only through the FIFO.
 * Hazard: A filter may point to a transmit buffer only for automatic answers to remote frames (TXEN = 1 and
 * RTREN = 1).
 * Register 4-10 p.20; Register 4-11 p.21; Register 4-12 p.21; Register 4-13 p.22; §9.2.1 p.56; §9.2.4 p.56;
 * external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_BUF_PNT_OFFSET 0x020U
#define DSPIC33_ECAN_BUF_PNT_COUNT 4U
#define DSPIC33_ECAN_BUF_PNT_STRIDE 0x002U
#define DSPIC33_ECAN_BUF_PNT_FIRST 1U
#define DSPIC33_ECAN_BUF_PNT_RESET 0x0000U
#define DSPIC33_ECAN_BUF_PNT_RESET_MASK 0xFFFFU
/* FnBP: Where messages that hit the filter of this number are stored. Access rw. Lane 0 is number 0 in the first
 * register.
 * Contradictions of the manual: fifo_pointer_code, bufpnt_titles, example_9_2_slips.
 */
#define DSPIC33_ECAN_BUF_PNT_FBP_Pos(lane) (0U + 4U * (lane))
#define DSPIC33_ECAN_BUF_PNT_FBP_Msk(lane) ((uint16_t)(0x000FU << (4U * (lane))))
#define DSPIC33_ECAN_BUF_PNT_FBP_Lanes 4U
#define DSPIC33_ECAN_BUF_PNT_FBP_Width 4U
#define DSPIC33_ECAN_BUF_PNT_FBP_Access "rw"
#define DSPIC33_ECAN_BUF_PNT_FBP_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_BUF_PNT_FBP_Pos(lane)) & DSPIC33_ECAN_BUF_PNT_FBP_Msk(lane)))
static inline uint16_t dspic33_ecan_buf_pnt_fbp_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_ECAN_ASSERT(lane < 4U);
    return (uint16_t)((reg & DSPIC33_ECAN_BUF_PNT_FBP_Msk(lane)) >> DSPIC33_ECAN_BUF_PNT_FBP_Pos(lane));
}
static inline uint16_t dspic33_ecan_buf_pnt_fbp_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(lane < 4U);
    DSPIC33_ECAN_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_BUF_PNT_FBP_Msk(lane)) | DSPIC33_ECAN_BUF_PNT_FBP_SET(lane, value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_buf_pnt(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 4U);
    return &regs->WINDOW.FILTER.BUFPNT[n - 1U];
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_buf_pnt_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n - 1U < 4U);
    uint16_t value = regs->WINDOW.FILTER.BUFPNT[n - 1U];
    regs->WINDOW.FILTER.BUFPNT[n - 1U] = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXMnSID: CAN Acceptance Filter Mask Standard Identifier Register.
 * Standard identifier part of a mask. A 1 makes the filter compare the bit, a 0 makes it accept either value.
 * Visible only in the window filter, while CTRL1.WIN is 1.
 * Hazard: The masks in the manual's Examples 9-1 and 9-2 are inverted; a 1 compares.
 * Register 4-6 p.18; Table 9-2 p.52; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXM_SID_OFFSET 0x030U
#define DSPIC33_ECAN_RXM_SID_COUNT 3U
#define DSPIC33_ECAN_RXM_SID_STRIDE 0x004U
#define DSPIC33_ECAN_RXM_SID_FIRST 0U
#define DSPIC33_ECAN_RXM_SID_RESET 0x0000U
#define DSPIC33_ECAN_RXM_SID_RESET_MASK 0x0014U
/* SID[10:0]: Mask of the standard identifier. 1 compares the bit, 0 ignores it. Access rw.
 * Contradictions of the manual: example_masks.
 */
#define DSPIC33_ECAN_RXM_SID_SID_Pos 5U
#define DSPIC33_ECAN_RXM_SID_SID_Msk 0xFFE0U
#define DSPIC33_ECAN_RXM_SID_SID_Width 11U
#define DSPIC33_ECAN_RXM_SID_SID_Access "rw"
#define DSPIC33_ECAN_RXM_SID_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXM_SID_SID_Pos) & DSPIC33_ECAN_RXM_SID_SID_Msk))
static inline uint16_t dspic33_ecan_rxm_sid_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXM_SID_SID_Msk) >> DSPIC33_ECAN_RXM_SID_SID_Pos);
}
static inline uint16_t dspic33_ecan_rxm_sid_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXM_SID_SID_Msk) | DSPIC33_ECAN_RXM_SID_SID_SET(value));
}
/* MIDE: Whether filters with this mask look at the identifier format. With 0 a standard message is compared in
 * SID only and an extended one in SID and EID. Access rw.
 * Contradictions of the manual: register_name_slips.
 * Register 4-6 p.18; Table 9-3 p.52
 */
#define DSPIC33_ECAN_RXM_SID_MIDE_Pos 3U
#define DSPIC33_ECAN_RXM_SID_MIDE_Msk 0x0008U
#define DSPIC33_ECAN_RXM_SID_MIDE_Width 1U
#define DSPIC33_ECAN_RXM_SID_MIDE_Access "rw"
#define DSPIC33_ECAN_RXM_SID_MIDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXM_SID_MIDE_Pos) & DSPIC33_ECAN_RXM_SID_MIDE_Msk))
static inline uint16_t dspic33_ecan_rxm_sid_mide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXM_SID_MIDE_Msk) >> DSPIC33_ECAN_RXM_SID_MIDE_Pos);
}
static inline uint16_t dspic33_ecan_rxm_sid_mide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXM_SID_MIDE_Msk) | DSPIC33_ECAN_RXM_SID_MIDE_SET(value));
}
/* EID[17:16]: Mask of the two highest bits of the extended identifier. 1 compares the bit, 0 ignores it. Access
 * rw.
 */
#define DSPIC33_ECAN_RXM_SID_EID_Pos 0U
#define DSPIC33_ECAN_RXM_SID_EID_Msk 0x0003U
#define DSPIC33_ECAN_RXM_SID_EID_Width 2U
#define DSPIC33_ECAN_RXM_SID_EID_Access "rw"
#define DSPIC33_ECAN_RXM_SID_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXM_SID_EID_Pos) & DSPIC33_ECAN_RXM_SID_EID_Msk))
static inline uint16_t dspic33_ecan_rxm_sid_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXM_SID_EID_Msk) >> DSPIC33_ECAN_RXM_SID_EID_Pos);
}
static inline uint16_t dspic33_ecan_rxm_sid_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXM_SID_EID_Msk) | DSPIC33_ECAN_RXM_SID_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxm_sid(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    return &regs->WINDOW.FILTER.RXM[n].RXMSID;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_rxm_sid_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    uint16_t value = regs->WINDOW.FILTER.RXM[n].RXMSID;
    regs->WINDOW.FILTER.RXM[n].RXMSID = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXMnEID: CAN Acceptance Filter Mask Extended Identifier Register.
 * Lower 16 bits of the extended identifier part of a mask.
 * Visible only in the window filter, while CTRL1.WIN is 1.
 * Register 4-7 p.19; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXM_EID_OFFSET 0x032U
#define DSPIC33_ECAN_RXM_EID_COUNT 3U
#define DSPIC33_ECAN_RXM_EID_STRIDE 0x004U
#define DSPIC33_ECAN_RXM_EID_FIRST 0U
#define DSPIC33_ECAN_RXM_EID_RESET 0x0000U
#define DSPIC33_ECAN_RXM_EID_RESET_MASK 0x0000U
/* EID[15:0]: Mask of the extended identifier. 1 compares the bit, 0 ignores it. Access rw.
 * Contradictions of the manual: example_masks.
 */
#define DSPIC33_ECAN_RXM_EID_EID_Pos 0U
#define DSPIC33_ECAN_RXM_EID_EID_Msk 0xFFFFU
#define DSPIC33_ECAN_RXM_EID_EID_Width 16U
#define DSPIC33_ECAN_RXM_EID_EID_Access "rw"
#define DSPIC33_ECAN_RXM_EID_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXM_EID_EID_Pos) & DSPIC33_ECAN_RXM_EID_EID_Msk))
static inline uint16_t dspic33_ecan_rxm_eid_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXM_EID_EID_Msk) >> DSPIC33_ECAN_RXM_EID_EID_Pos);
}
static inline uint16_t dspic33_ecan_rxm_eid_eid_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXM_EID_EID_Msk) | DSPIC33_ECAN_RXM_EID_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxm_eid(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    return &regs->WINDOW.FILTER.RXM[n].RXMEID;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_rxm_eid_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    uint16_t value = regs->WINDOW.FILTER.RXM[n].RXMEID;
    regs->WINDOW.FILTER.RXM[n].RXMEID = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXFnSID: CAN Acceptance Filter Standard Identifier Register.
 * Standard identifier part and format of an acceptance filter.
 * Visible only in the window filter, while CTRL1.WIN is 1.
 * Register 4-4 p.17; Table 9-2 p.52; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXF_SID_OFFSET 0x040U
#define DSPIC33_ECAN_RXF_SID_COUNT 16U
#define DSPIC33_ECAN_RXF_SID_STRIDE 0x004U
#define DSPIC33_ECAN_RXF_SID_FIRST 0U
#define DSPIC33_ECAN_RXF_SID_RESET 0x0000U
#define DSPIC33_ECAN_RXF_SID_RESET_MASK 0x0014U
/* SID[10:0]: Standard identifier, or upper part of an extended identifier, that a message must have where the
 * mask compares. Access rw.
 */
#define DSPIC33_ECAN_RXF_SID_SID_Pos 5U
#define DSPIC33_ECAN_RXF_SID_SID_Msk 0xFFE0U
#define DSPIC33_ECAN_RXF_SID_SID_Width 11U
#define DSPIC33_ECAN_RXF_SID_SID_Access "rw"
#define DSPIC33_ECAN_RXF_SID_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXF_SID_SID_Pos) & DSPIC33_ECAN_RXF_SID_SID_Msk))
static inline uint16_t dspic33_ecan_rxf_sid_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXF_SID_SID_Msk) >> DSPIC33_ECAN_RXF_SID_SID_Pos);
}
static inline uint16_t dspic33_ecan_rxf_sid_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXF_SID_SID_Msk) | DSPIC33_ECAN_RXF_SID_SID_SET(value));
}
/* EXIDE: Format that the filter accepts. Ignored if MIDE of the filter's mask is 0. Access rw.
 * Contradictions of the manual: register_name_slips.
 * Register 4-4 p.17; Table 9-3 p.52
 */
#define DSPIC33_ECAN_RXF_SID_EXIDE_Pos 3U
#define DSPIC33_ECAN_RXF_SID_EXIDE_Msk 0x0008U
#define DSPIC33_ECAN_RXF_SID_EXIDE_Width 1U
#define DSPIC33_ECAN_RXF_SID_EXIDE_Access "rw"
#define DSPIC33_ECAN_RXF_SID_EXIDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXF_SID_EXIDE_Pos) & DSPIC33_ECAN_RXF_SID_EXIDE_Msk))
static inline uint16_t dspic33_ecan_rxf_sid_exide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXF_SID_EXIDE_Msk) >> DSPIC33_ECAN_RXF_SID_EXIDE_Pos);
}
static inline uint16_t dspic33_ecan_rxf_sid_exide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXF_SID_EXIDE_Msk) | DSPIC33_ECAN_RXF_SID_EXIDE_SET(value));
}
/* EID[17:16]: Two highest bits of the extended identifier, or first data bits in DeviceNet filtering. Access rw.
 * Register 4-4 p.17; §9.5 p.61
 */
#define DSPIC33_ECAN_RXF_SID_EID_Pos 0U
#define DSPIC33_ECAN_RXF_SID_EID_Msk 0x0003U
#define DSPIC33_ECAN_RXF_SID_EID_Width 2U
#define DSPIC33_ECAN_RXF_SID_EID_Access "rw"
#define DSPIC33_ECAN_RXF_SID_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXF_SID_EID_Pos) & DSPIC33_ECAN_RXF_SID_EID_Msk))
static inline uint16_t dspic33_ecan_rxf_sid_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXF_SID_EID_Msk) >> DSPIC33_ECAN_RXF_SID_EID_Pos);
}
static inline uint16_t dspic33_ecan_rxf_sid_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXF_SID_EID_Msk) | DSPIC33_ECAN_RXF_SID_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxf_sid(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    return &regs->WINDOW.FILTER.RXF[n].RXFSID;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_rxf_sid_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    uint16_t value = regs->WINDOW.FILTER.RXF[n].RXFSID;
    regs->WINDOW.FILTER.RXF[n].RXFSID = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXFnEID: CAN Acceptance Filter Extended Identifier Register.
 * Lower 16 bits of the extended identifier of an acceptance filter.
 * Visible only in the window filter, while CTRL1.WIN is 1.
 * Register 4-5 p.18; external: linker_mc710 (offset)
 */
#define DSPIC33_ECAN_RXF_EID_OFFSET 0x042U
#define DSPIC33_ECAN_RXF_EID_COUNT 16U
#define DSPIC33_ECAN_RXF_EID_STRIDE 0x004U
#define DSPIC33_ECAN_RXF_EID_FIRST 0U
#define DSPIC33_ECAN_RXF_EID_RESET 0x0000U
#define DSPIC33_ECAN_RXF_EID_RESET_MASK 0x0000U
/* EID[15:0]: Extended identifier, or data bits in DeviceNet filtering, that a message must have where the mask
 * compares. Access rw.
 * Contradictions of the manual: example_9_2_slips.
 */
#define DSPIC33_ECAN_RXF_EID_EID_Pos 0U
#define DSPIC33_ECAN_RXF_EID_EID_Msk 0xFFFFU
#define DSPIC33_ECAN_RXF_EID_EID_Width 16U
#define DSPIC33_ECAN_RXF_EID_EID_Access "rw"
#define DSPIC33_ECAN_RXF_EID_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RXF_EID_EID_Pos) & DSPIC33_ECAN_RXF_EID_EID_Msk))
static inline uint16_t dspic33_ecan_rxf_eid_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RXF_EID_EID_Msk) >> DSPIC33_ECAN_RXF_EID_EID_Pos);
}
static inline uint16_t dspic33_ecan_rxf_eid_eid_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RXF_EID_EID_Msk) | DSPIC33_ECAN_RXF_EID_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_ecan_rxf_eid(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    return &regs->WINDOW.FILTER.RXF[n].RXFEID;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_ecan_rxf_eid_modify(dspic33_ecan_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    uint16_t value = regs->WINDOW.FILTER.RXF[n].RXFEID;
    regs->WINDOW.FILTER.RXF[n].RXFEID = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* Window buffer: Buffer status, transmit control and the DMA data registers. Selected after reset.
 * Selects it in CTRL1.WIN with one read and one store. Its registers are the member BUFFER of the window; an
 * interrupt that uses another window in between has to restore this one.
 * Register 4-23 p.30; Table 3-2 p.9; Table 3-5 p.12
 */
static inline void dspic33_ecan_select_buffer_window(dspic33_ecan_regs_t *regs)
{
    dspic33_ecan_ctrl1_modify(regs, DSPIC33_ECAN_CTRL1_WIN_Msk, DSPIC33_ECAN_CTRL1_WIN_SET(0U));
}

/* Window filter: Filter buffer pointers, acceptance masks and acceptance filters, at the addresses of the buffer
 * window.
 * Selects it in CTRL1.WIN with one read and one store. Its registers are the member FILTER of the window; an
 * interrupt that uses another window in between has to restore this one.
 * Register 4-23 p.30; Table 3-3 p.10; Table 3-6 p.13; external: linker_mc710 (shared addresses)
 */
static inline void dspic33_ecan_select_filter_window(dspic33_ecan_regs_t *regs)
{
    dspic33_ecan_ctrl1_modify(regs, DSPIC33_ECAN_CTRL1_WIN_Msk, DSPIC33_ECAN_CTRL1_WIN_SET(1U));
}

/* RXMID: 29-bit mask of the extended identifier, SID[10:0] above EID[17:0].
 * Accessed in the order RXMnEID, RXMnSID.
 * Register 4-6 p.18; Register 4-7 p.19; Example 9-2 p.54
 */
static inline uint32_t dspic33_ecan_rxm_id_read(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    const uint16_t part0 = regs->WINDOW.FILTER.RXM[n].RXMEID;
    const uint16_t part1 = regs->WINDOW.FILTER.RXM[n].RXMSID;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0x0003U) >> 0U) << 16U) | ((uint32_t)((part1 & 0xFFE0U) >> 5U) << 18U);
}
static inline void dspic33_ecan_rxm_id_write(dspic33_ecan_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    regs->WINDOW.FILTER.RXM[n].RXMEID = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    dspic33_ecan_rxm_sid_modify(regs, n, 0xFFE3U, (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0x0003U) | (uint16_t)(((uint16_t)(value >> 18U) << 5U) & 0xFFE0U)));
}

/* RXFID: 29-bit extended identifier of a filter, SID[10:0] above EID[17:0].
 * Accessed in the order RXFnEID, RXFnSID.
 * Register 4-4 p.17; Register 4-5 p.18; Example 9-2 p.54
 */
static inline uint32_t dspic33_ecan_rxf_id_read(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    const uint16_t part0 = regs->WINDOW.FILTER.RXF[n].RXFEID;
    const uint16_t part1 = regs->WINDOW.FILTER.RXF[n].RXFSID;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0x0003U) >> 0U) << 16U) | ((uint32_t)((part1 & 0xFFE0U) >> 5U) << 18U);
}
static inline void dspic33_ecan_rxf_id_write(dspic33_ecan_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    regs->WINDOW.FILTER.RXF[n].RXFEID = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    dspic33_ecan_rxf_sid_modify(regs, n, 0xFFE3U, (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0x0003U) | (uint16_t)(((uint16_t)(value >> 18U) << 5U) & 0xFFE0U)));
}

/* RXMEID18: Mask of the 18 bits below the standard identifier, as used for the extended identifier and for
 * DeviceNet data bits.
 * Accessed in the order RXMnEID, RXMnSID.
 * Register 4-6 p.18; Register 4-7 p.19
 */
static inline uint32_t dspic33_ecan_rxm_eid18_read(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    const uint16_t part0 = regs->WINDOW.FILTER.RXM[n].RXMEID;
    const uint16_t part1 = regs->WINDOW.FILTER.RXM[n].RXMSID;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0x0003U) >> 0U) << 16U);
}
static inline void dspic33_ecan_rxm_eid18_write(dspic33_ecan_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_ECAN_ASSERT(n < 3U);
    regs->WINDOW.FILTER.RXM[n].RXMEID = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    dspic33_ecan_rxm_sid_modify(regs, n, 0x0003U, (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0x0003U)));
}

/* RXFEID18: The 18 bits below the standard identifier, as used for the extended identifier and for DeviceNet
 * data bits.
 * Accessed in the order RXFnEID, RXFnSID.
 * Register 4-4 p.17; Register 4-5 p.18; §9.5 p.61
 */
static inline uint32_t dspic33_ecan_rxf_eid18_read(dspic33_ecan_regs_t *regs, unsigned int n)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    const uint16_t part0 = regs->WINDOW.FILTER.RXF[n].RXFEID;
    const uint16_t part1 = regs->WINDOW.FILTER.RXF[n].RXFSID;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0x0003U) >> 0U) << 16U);
}
static inline void dspic33_ecan_rxf_eid18_write(dspic33_ecan_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_ECAN_ASSERT(n < 16U);
    regs->WINDOW.FILTER.RXF[n].RXFEID = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    dspic33_ecan_rxf_sid_modify(regs, n, 0x0003U, (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0x0003U)));
}

/* TX_BUFFER: Message buffer, as software writes it for transmission.
 * Eight words in DMA RAM; transmit and receive buffers have the same layout. Every message moves as eight words,
 * whatever its DLC. Only the buffers 0 to 7 can transmit.
 * Eight data bytes, two to a word, the byte with the even number in the low half. Byte 0 is the first on the
 * bus. Bytes beyond the DLC are not sent.
 * §9.0 p.50; §10.1 p.64; Figure 8-1 p.44
 */
typedef struct {
    volatile uint16_t WORD0; /* Standard identifier and format. Bits 15 to 13 do not matter. The page of Buffer 5-1 is missing from the cited copy; the positions follow from Figure 8-1 and from the values of Examples 8-1 to 8-3. */
    volatile uint16_t WORD1; /* Middle part of an extended identifier. Bits 15 to 12 do not matter. The page of Buffer 5-2 is missing from the cited copy. */
    volatile uint16_t WORD2; /* Low part of an extended identifier, frame type and data length. */
    volatile uint16_t PAYLOAD[4];
    volatile uint16_t WORD7; /* Transferred with the others, but not used for transmission. */
} dspic33_ecan_tx_buffer_t;
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_tx_buffer_t, WORD0) == 0x000U, dspic33_ecan_tx_buffer_at_WORD0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_tx_buffer_t, WORD1) == 0x002U, dspic33_ecan_tx_buffer_at_WORD1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_tx_buffer_t, WORD2) == 0x004U, dspic33_ecan_tx_buffer_at_WORD2);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_tx_buffer_t, PAYLOAD) == 0x006U, dspic33_ecan_tx_buffer_at_PAYLOAD);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_tx_buffer_t, WORD7) == 0x00EU, dspic33_ecan_tx_buffer_at_WORD7);
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_tx_buffer_t) == 0x010U, dspic33_ecan_tx_buffer_size);
#define DSPIC33_ECAN_TX_BUFFER_HEADER_BYTES 6U
/* Word WORD0 of TX_BUFFER: Standard identifier and format. Bits 15 to 13 do not matter. The page of Buffer 5-1
 * is missing from the cited copy; the positions follow from Figure 8-1 and from the values of Examples 8-1 to
 * 8-3.
 * Figure 8-1 p.44; Example 8-1 p.45; Example 8-2 p.46; Example 8-3 p.49; §5.0 Buffer 5-1 p.34; external:
 * frm_dspic33e (meaning of SRR); external: datasheet_dspic33e (bit positions)
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD0_OFFSET 0x000U
/* SID[10:0]: Standard identifier, or the upper 11 bits of an extended identifier. Access rw. */
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Pos 2U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Msk 0x1FFCU
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Width 11U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD0_SID_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD0_SID_SET(value));
}
/* SRR: Substitute remote request. Must be 1 in an extended message. In a standard message 1 requests a remote
 * frame and 0 a data frame. Access rw.
 * §2.2 p.6; external: frm_dspic33e
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Pos 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Msk 0x0002U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Width 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word0_srr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word0_srr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD0_SRR_SET(value));
}
/* IDE: Format of the identifier. Access rw.
 * Example 8-2 p.46; §2.1 p.5
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Pos 0U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Msk 0x0001U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Width 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word0_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word0_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD0_IDE_SET(value));
}
/* Word WORD1 of TX_BUFFER: Middle part of an extended identifier. Bits 15 to 12 do not matter. The page of
 * Buffer 5-2 is missing from the cited copy.
 * Figure 8-1 p.44; Example 8-2 p.46; §5.0 Buffer 5-2 p.34; external: datasheet_dspic33e (bit positions)
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD1_OFFSET 0x002U
/* EID[17:6]: Bits 17 to 6 of the extended identifier. Access rw. */
#define DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Pos 0U
#define DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Msk 0x0FFFU
#define DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Width 12U
#define DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 4095U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD1_EID_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD1_EID_SET(value));
}
/* Word WORD2 of TX_BUFFER: Low part of an extended identifier, frame type and data length.
 * §5.0 Buffer 5-3 p.35
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_OFFSET 0x004U
/* EID[5:0]: Bits 5 to 0 of the extended identifier. Access rw. */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Pos 10U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Msk 0xFC00U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Width 6U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD2_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word2_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word2_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 63U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD2_EID_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD2_EID_SET(value));
}
/* RTR: Remote transmission request of an extended message. With 1 a remote frame is sent. Ignored in a standard
 * message, where SRR decides. Access rw.
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Pos 9U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Msk 0x0200U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Width 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD2_RTR_SET(value));
}
/* RB1: Reserved bit 1 of the frame. Has to be 0. Access rw. Software has to write 0x0. */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Pos 8U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Msk 0x0100U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Width 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Msk))
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_MustWrite 0U
static inline uint16_t dspic33_ecan_tx_buffer_word2_rb1_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word2_rb1_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD2_RB1_SET(value));
}
/* RB0: Reserved bit 0 of the frame. Has to be 0. Access rw. Software has to write 0x0. */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Pos 4U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Msk 0x0010U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Width 1U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Msk))
#define DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_MustWrite 0U
static inline uint16_t dspic33_ecan_tx_buffer_word2_rb0_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word2_rb0_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD2_RB0_SET(value));
}
/* DLC: Data length code, the number of data bytes. A remote frame carries it without data. Access rw. May be
 * programmed with 0 to 8. Means value bytes.
 * §5.0 Buffer 5-3 p.35; §2.3 p.7
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Pos 0U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Msk 0x000FU
#define DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Width 4U
#define DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Access "rw"
#define DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Pos) & DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Msk))
static inline uint16_t dspic33_ecan_tx_buffer_word2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Msk) >> DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Pos);
}
static inline uint16_t dspic33_ecan_tx_buffer_word2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 8U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_Msk) | DSPIC33_ECAN_TX_BUFFER_WORD2_DLC_SET(value));
}
/* Word WORD7 of TX_BUFFER: Transferred with the others, but not used for transmission.
 * §5.0 Buffer 5-8 p.37
 */
#define DSPIC33_ECAN_TX_BUFFER_WORD7_OFFSET 0x00EU
#define DSPIC33_ECAN_TX_BUFFER_PAYLOAD_MAX 8U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define DSPIC33_ECAN_TX_BUFFER_BYTES(payload) (6U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int dspic33_ecan_tx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void dspic33_ecan_tx_buffer_read_payload(const dspic33_ecan_tx_buffer_t *element, uint8_t *data, size_t count)
{
    DSPIC33_ECAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 2U) {
        const uint16_t word = element->PAYLOAD[at / 2U];
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void dspic33_ecan_tx_buffer_write_payload(dspic33_ecan_tx_buffer_t *element, const uint8_t *data, size_t count)
{
    DSPIC33_ECAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 2U) {
        uint16_t word = 0;
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            word = (uint16_t)(word | (uint16_t)((uint16_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 2U] = word;
    }
}
/* ID: 29-bit identifier of an extended message. A standard message has its identifier in WORD0.SID alone.
 * Figure 8-1 p.44; Example 9-2 p.54
 */
static inline uint32_t dspic33_ecan_tx_buffer_extended_id_read(const dspic33_ecan_tx_buffer_t *element)
{
    const uint16_t part0 = element->WORD2;
    const uint16_t part1 = element->WORD1;
    const uint16_t part2 = element->WORD0;
    return ((uint32_t)((part0 & 0xFC00U) >> 10U) << 0U) | ((uint32_t)((part1 & 0x0FFFU) >> 0U) << 6U) | ((uint32_t)((part2 & 0x1FFCU) >> 2U) << 18U);
}
static inline void dspic33_ecan_tx_buffer_extended_id_write(dspic33_ecan_tx_buffer_t *element, uint32_t value)
{
    element->WORD2 = (uint16_t)((element->WORD2 & (uint16_t)~0xFC00U) | (uint16_t)(((uint16_t)(value >> 0U) << 10U) & 0xFC00U));
    element->WORD1 = (uint16_t)((element->WORD1 & (uint16_t)~0x0FFFU) | (uint16_t)(((uint16_t)(value >> 6U) << 0U) & 0x0FFFU));
    element->WORD0 = (uint16_t)((element->WORD0 & (uint16_t)~0x1FFCU) | (uint16_t)(((uint16_t)(value >> 18U) << 2U) & 0x1FFCU));
}

/* RX_BUFFER: Message buffer, as the module writes it on reception.
 * The same eight words after reception. Word 7 tells which filter the message hit. The receive DMA channel
 * writes all eight words before the module sets RXFUL.
 * Eight data bytes, two to a word, the byte with the even number in the low half. Byte 0 is the first on the
 * bus. Bytes beyond the DLC are not sent.
 * §9.0 p.50; §10.1.1 p.65
 */
typedef struct {
    volatile uint16_t WORD0; /* Standard identifier and format of the received message. The page of Buffer 5-1 is missing from the cited copy. */
    volatile uint16_t WORD1; /* Middle part of an extended identifier. Bits 15 to 12 do not matter. The page of Buffer 5-2 is missing from the cited copy. */
    volatile uint16_t WORD2; /* Low part of an extended identifier, frame type and data length of the received message. */
    volatile uint16_t PAYLOAD[4];
    volatile uint16_t WORD7; /* Filter number. */
} dspic33_ecan_rx_buffer_t;
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_rx_buffer_t, WORD0) == 0x000U, dspic33_ecan_rx_buffer_at_WORD0);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_rx_buffer_t, WORD1) == 0x002U, dspic33_ecan_rx_buffer_at_WORD1);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_rx_buffer_t, WORD2) == 0x004U, dspic33_ecan_rx_buffer_at_WORD2);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_rx_buffer_t, PAYLOAD) == 0x006U, dspic33_ecan_rx_buffer_at_PAYLOAD);
DSPIC33_ECAN_STATIC_ASSERT(offsetof(dspic33_ecan_rx_buffer_t, WORD7) == 0x00EU, dspic33_ecan_rx_buffer_at_WORD7);
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rx_buffer_t) == 0x010U, dspic33_ecan_rx_buffer_size);
#define DSPIC33_ECAN_RX_BUFFER_HEADER_BYTES 6U
/* Word WORD0 of RX_BUFFER: Standard identifier and format of the received message. The page of Buffer 5-1 is
 * missing from the cited copy.
 * Figure 8-1 p.44; §5.0 Buffer 5-1 p.34; external: frm_dspic33e (meaning of SRR)
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD0_OFFSET 0x000U
/* SID[10:0]: Standard identifier, or the upper 11 bits of an extended identifier. Access rw.
 * Figure 8-1 p.44; Example 8-1 p.45; Example 8-2 p.46; Example 8-3 p.49; §5.0 Buffer 5-1 p.34; external:
 * frm_dspic33e (meaning of SRR); external: datasheet_dspic33e (bit positions)
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Pos 2U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Msk 0x1FFCU
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Width 11U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD0_SID_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD0_SID_SET(value));
}
/* IDE: Format of the identifier. Access rw.
 * Example 8-2 p.46; §2.1 p.5
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Pos 0U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Msk 0x0001U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Width 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word0_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word0_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD0_IDE_SET(value));
}
/* SRR: In a standard message 1 tells that a remote frame was received. In an extended message it is the SRR bit
 * of the frame. Access rw.
 * external: frm_dspic33e
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Pos 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Msk 0x0002U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Width 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word0_srr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word0_srr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD0_SRR_SET(value));
}
/* Word WORD1 of RX_BUFFER: Middle part of an extended identifier. Bits 15 to 12 do not matter. The page of
 * Buffer 5-2 is missing from the cited copy.
 * Figure 8-1 p.44; Example 8-2 p.46; §5.0 Buffer 5-2 p.34; external: datasheet_dspic33e (bit positions)
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD1_OFFSET 0x002U
/* EID[17:6]: Bits 17 to 6 of the extended identifier. Access rw. */
#define DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Pos 0U
#define DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Msk 0x0FFFU
#define DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Width 12U
#define DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 4095U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD1_EID_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD1_EID_SET(value));
}
/* Word WORD2 of RX_BUFFER: Low part of an extended identifier, frame type and data length of the received
 * message.
 * §5.0 Buffer 5-3 p.35
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_OFFSET 0x004U
/* EID[5:0]: Bits 5 to 0 of the extended identifier. Access rw. */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Pos 10U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Msk 0xFC00U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Width 6U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD2_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word2_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word2_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 63U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD2_EID_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD2_EID_SET(value));
}
/* RTR: In an extended message 1 tells that a remote frame was received. Without meaning in a standard message.
 * Access rw.
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Pos 9U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Msk 0x0200U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Width 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD2_RTR_SET(value));
}
/* RB1: Reserved bit 1 of the frame. Access rw. */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Pos 8U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Msk 0x0100U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Width 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word2_rb1_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word2_rb1_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD2_RB1_SET(value));
}
/* RB0: Reserved bit 0 of the frame. Access rw. */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Pos 4U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Msk 0x0010U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Width 1U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word2_rb0_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word2_rb0_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD2_RB0_SET(value));
}
/* DLC: Data length code of the received message, the number of data bytes that are valid. Access rw. Means value
 * bytes.
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Pos 0U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Msk 0x000FU
#define DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Width 4U
#define DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD2_DLC_SET(value));
}
/* Word WORD7 of RX_BUFFER: Filter number.
 * §5.0 Buffer 5-8 p.37
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD7_OFFSET 0x00EU
/* FILHIT: Number of the filter that caused the message to be stored here, 0 to 15. Written by the module for
 * receive buffers only. Access rw.
 */
#define DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Pos 8U
#define DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Msk 0x1F00U
#define DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Width 5U
#define DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Access "rw"
#define DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Pos) & DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Msk))
static inline uint16_t dspic33_ecan_rx_buffer_word7_filhit_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Msk) >> DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Pos);
}
static inline uint16_t dspic33_ecan_rx_buffer_word7_filhit_set(uint16_t reg, uint16_t value)
{
    DSPIC33_ECAN_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_Msk) | DSPIC33_ECAN_RX_BUFFER_WORD7_FILHIT_SET(value));
}
#define DSPIC33_ECAN_RX_BUFFER_PAYLOAD_MAX 8U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define DSPIC33_ECAN_RX_BUFFER_BYTES(payload) (6U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int dspic33_ecan_rx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void dspic33_ecan_rx_buffer_read_payload(const dspic33_ecan_rx_buffer_t *element, uint8_t *data, size_t count)
{
    DSPIC33_ECAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 2U) {
        const uint16_t word = element->PAYLOAD[at / 2U];
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void dspic33_ecan_rx_buffer_write_payload(dspic33_ecan_rx_buffer_t *element, const uint8_t *data, size_t count)
{
    DSPIC33_ECAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 2U) {
        uint16_t word = 0;
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            word = (uint16_t)(word | (uint16_t)((uint16_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 2U] = word;
    }
}
/* ID: 29-bit identifier of an extended message. A standard message has its identifier in WORD0.SID alone.
 * Figure 8-1 p.44; Example 9-2 p.54
 */
static inline uint32_t dspic33_ecan_rx_buffer_extended_id_read(const dspic33_ecan_rx_buffer_t *element)
{
    const uint16_t part0 = element->WORD2;
    const uint16_t part1 = element->WORD1;
    const uint16_t part2 = element->WORD0;
    return ((uint32_t)((part0 & 0xFC00U) >> 10U) << 0U) | ((uint32_t)((part1 & 0x0FFFU) >> 0U) << 6U) | ((uint32_t)((part2 & 0x1FFCU) >> 2U) << 18U);
}
static inline void dspic33_ecan_rx_buffer_extended_id_write(dspic33_ecan_rx_buffer_t *element, uint32_t value)
{
    element->WORD2 = (uint16_t)((element->WORD2 & (uint16_t)~0xFC00U) | (uint16_t)(((uint16_t)(value >> 0U) << 10U) & 0xFC00U));
    element->WORD1 = (uint16_t)((element->WORD1 & (uint16_t)~0x0FFFU) | (uint16_t)(((uint16_t)(value >> 6U) << 0U) & 0x0FFFU));
    element->WORD0 = (uint16_t)((element->WORD0 & (uint16_t)~0x1FFCU) | (uint16_t)(((uint16_t)(value >> 18U) << 2U) & 0x1FFCU));
}

/* C1 of dsPIC33FJ256MC710, dsPIC33FJ128MC802.
 * First module. The request numbers for reception and transmission are also printed in Table 10-1.
 * external: linker_mc710; external: linker_mc802; Table 10-1 p.63 (interrupt numbers)
 */
#ifndef DSPIC33_ECAN_C1_BASE
#define DSPIC33_ECAN_C1_BASE UINT32_C(0x00000400)
#endif
#define DSPIC33_ECAN_C1 ((dspic33_ecan_regs_t *)(uintptr_t)DSPIC33_ECAN_C1_BASE)
#define DSPIC33_ECAN_C1_EVENT_IRQ 35
#define DSPIC33_ECAN_C1_RX_DATA_IRQ 34
#define DSPIC33_ECAN_C1_TX_DATA_IRQ 70

/* C2 of dsPIC33FJ256MC710.
 * Second module. The request numbers for reception and transmission are also printed in Table 10-1.
 * external: linker_mc710; Table 10-1 p.63 (interrupt numbers)
 */
#ifndef DSPIC33_ECAN_C2_BASE
#define DSPIC33_ECAN_C2_BASE UINT32_C(0x00000500)
#endif
#define DSPIC33_ECAN_C2 ((dspic33_ecan_regs_t *)(uintptr_t)DSPIC33_ECAN_C2_BASE)
#define DSPIC33_ECAN_C2_EVENT_IRQ 56
#define DSPIC33_ECAN_C2_RX_DATA_IRQ 55
#define DSPIC33_ECAN_C2_TX_DATA_IRQ 71

/* C1_GS606 of dsPIC33FJ64GS606.
 * The only module of this device, at another base address.
 * external: definition_gs606
 */
#ifndef DSPIC33_ECAN_C1_GS606_BASE
#define DSPIC33_ECAN_C1_GS606_BASE UINT32_C(0x00000600)
#endif
#define DSPIC33_ECAN_C1_GS606 ((dspic33_ecan_regs_t *)(uintptr_t)DSPIC33_ECAN_C1_GS606_BASE)
#define DSPIC33_ECAN_C1_GS606_EVENT_IRQ 35
#define DSPIC33_ECAN_C1_GS606_RX_DATA_IRQ 34
#define DSPIC33_ECAN_C1_GS606_TX_DATA_IRQ 70

/* The manufacturer's names, such as C1CON and C1CONbits, over the same layout.
 * Define DSPIC33_ECAN_MICROCHIP_NAMES before including this header, and DSPIC33_ECAN_C1_BASE,
 * DSPIC33_ECAN_C2_BASE with the base addresses where no default stands below.
 * Containers have fixed width. A register with flags that a bit-field assignment would clear, or with fields
 * that the read changes, has a const view: clear its flags with the functions above.
 */
#ifdef DSPIC33_ECAN_MICROCHIP_NAMES
#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "bit-fields are laid out for little-endian compilers"
#endif
typedef struct {
    uint16_t WIN : 1;
    uint16_t : 2;
    uint16_t CANCAP : 1;
    uint16_t : 1;
    uint16_t OPMODE : 3;
    uint16_t REQOP : 3;
    uint16_t : 1;
    uint16_t ABAT : 1;
    uint16_t CSIDL : 1;
    uint16_t : 2;
} dspic33_ecan_ctrl1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_ctrl1_bits_t) == 2U, dspic33_ecan_ctrl1_bits_t_size);
typedef struct {
    uint16_t DNCNT : 5;
    uint16_t : 11;
} dspic33_ecan_ctrl2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_ctrl2_bits_t) == 2U, dspic33_ecan_ctrl2_bits_t_size);
typedef struct {
    uint16_t ICODE : 7;
    uint16_t : 1;
    uint16_t FILHIT : 5;
    uint16_t : 3;
} dspic33_ecan_vec_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_vec_bits_t) == 2U, dspic33_ecan_vec_bits_t_size);
typedef struct {
    uint16_t FSA : 5;
    uint16_t : 8;
    uint16_t DMABS : 3;
} dspic33_ecan_fctrl_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_fctrl_bits_t) == 2U, dspic33_ecan_fctrl_bits_t_size);
typedef struct {
    uint16_t FNRB : 6;
    uint16_t : 2;
    uint16_t FBP : 6;
    uint16_t : 2;
} dspic33_ecan_fifo_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_fifo_bits_t) == 2U, dspic33_ecan_fifo_bits_t_size);
typedef struct {
    uint16_t TBIF : 1;
    uint16_t RBIF : 1;
    uint16_t RBOVIF : 1;
    uint16_t FIFOIF : 1;
    uint16_t : 1;
    uint16_t ERRIF : 1;
    uint16_t WAKIF : 1;
    uint16_t IVRIF : 1;
    uint16_t EWARN : 1;
    uint16_t RXWAR : 1;
    uint16_t TXWAR : 1;
    uint16_t RXBP : 1;
    uint16_t TXBP : 1;
    uint16_t TXBO : 1;
    uint16_t : 2;
} dspic33_ecan_intf_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_intf_bits_t) == 2U, dspic33_ecan_intf_bits_t_size);
typedef struct {
    uint16_t TBIE : 1;
    uint16_t RBIE : 1;
    uint16_t RBOVIE : 1;
    uint16_t FIFOIE : 1;
    uint16_t : 1;
    uint16_t ERRIE : 1;
    uint16_t WAKIE : 1;
    uint16_t IVRIE : 1;
    uint16_t : 8;
} dspic33_ecan_inte_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_inte_bits_t) == 2U, dspic33_ecan_inte_bits_t_size);
typedef struct {
    uint16_t RERRCNT : 8;
    uint16_t TERRCNT : 8;
} dspic33_ecan_ec_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_ec_bits_t) == 2U, dspic33_ecan_ec_bits_t_size);
typedef struct {
    uint16_t BRP : 6;
    uint16_t SJW : 2;
    uint16_t : 8;
} dspic33_ecan_cfg1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_cfg1_bits_t) == 2U, dspic33_ecan_cfg1_bits_t_size);
typedef struct {
    uint16_t PRSEG : 3;
    uint16_t SEG1PH : 3;
    uint16_t SAM : 1;
    uint16_t SEG2PHTS : 1;
    uint16_t SEG2PH : 3;
    uint16_t : 3;
    uint16_t WAKFIL : 1;
    uint16_t : 1;
} dspic33_ecan_cfg2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_cfg2_bits_t) == 2U, dspic33_ecan_cfg2_bits_t_size);
typedef struct {
    uint16_t FLTEN0 : 1;
    uint16_t FLTEN1 : 1;
    uint16_t FLTEN2 : 1;
    uint16_t FLTEN3 : 1;
    uint16_t FLTEN4 : 1;
    uint16_t FLTEN5 : 1;
    uint16_t FLTEN6 : 1;
    uint16_t FLTEN7 : 1;
    uint16_t FLTEN8 : 1;
    uint16_t FLTEN9 : 1;
    uint16_t FLTEN10 : 1;
    uint16_t FLTEN11 : 1;
    uint16_t FLTEN12 : 1;
    uint16_t FLTEN13 : 1;
    uint16_t FLTEN14 : 1;
    uint16_t FLTEN15 : 1;
} dspic33_ecan_fen1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_fen1_bits_t) == 2U, dspic33_ecan_fen1_bits_t_size);
typedef struct {
    uint16_t F0MSK : 2;
    uint16_t F1MSK : 2;
    uint16_t F2MSK : 2;
    uint16_t F3MSK : 2;
    uint16_t F4MSK : 2;
    uint16_t F5MSK : 2;
    uint16_t F6MSK : 2;
    uint16_t F7MSK : 2;
} dspic33_ecan_fmsksel1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_fmsksel1_bits_t) == 2U, dspic33_ecan_fmsksel1_bits_t_size);
typedef struct {
    uint16_t F8MSK : 2;
    uint16_t F9MSK : 2;
    uint16_t F10MSK : 2;
    uint16_t F11MSK : 2;
    uint16_t F12MSK : 2;
    uint16_t F13MSK : 2;
    uint16_t F14MSK : 2;
    uint16_t F15MSK : 2;
} dspic33_ecan_fmsksel2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_fmsksel2_bits_t) == 2U, dspic33_ecan_fmsksel2_bits_t_size);
typedef struct {
    uint16_t RXFUL0 : 1;
    uint16_t RXFUL1 : 1;
    uint16_t RXFUL2 : 1;
    uint16_t RXFUL3 : 1;
    uint16_t RXFUL4 : 1;
    uint16_t RXFUL5 : 1;
    uint16_t RXFUL6 : 1;
    uint16_t RXFUL7 : 1;
    uint16_t RXFUL8 : 1;
    uint16_t RXFUL9 : 1;
    uint16_t RXFUL10 : 1;
    uint16_t RXFUL11 : 1;
    uint16_t RXFUL12 : 1;
    uint16_t RXFUL13 : 1;
    uint16_t RXFUL14 : 1;
    uint16_t RXFUL15 : 1;
} dspic33_ecan_rxful1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxful1_bits_t) == 2U, dspic33_ecan_rxful1_bits_t_size);
typedef struct {
    uint16_t F0BP : 4;
    uint16_t F1BP : 4;
    uint16_t F2BP : 4;
    uint16_t F3BP : 4;
} dspic33_ecan_bufpnt1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_bufpnt1_bits_t) == 2U, dspic33_ecan_bufpnt1_bits_t_size);
typedef struct {
    uint16_t RXFUL16 : 1;
    uint16_t RXFUL17 : 1;
    uint16_t RXFUL18 : 1;
    uint16_t RXFUL19 : 1;
    uint16_t RXFUL20 : 1;
    uint16_t RXFUL21 : 1;
    uint16_t RXFUL22 : 1;
    uint16_t RXFUL23 : 1;
    uint16_t RXFUL24 : 1;
    uint16_t RXFUL25 : 1;
    uint16_t RXFUL26 : 1;
    uint16_t RXFUL27 : 1;
    uint16_t RXFUL28 : 1;
    uint16_t RXFUL29 : 1;
    uint16_t RXFUL30 : 1;
    uint16_t RXFUL31 : 1;
} dspic33_ecan_rxful2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxful2_bits_t) == 2U, dspic33_ecan_rxful2_bits_t_size);
typedef struct {
    uint16_t F4BP : 4;
    uint16_t F5BP : 4;
    uint16_t F6BP : 4;
    uint16_t F7BP : 4;
} dspic33_ecan_bufpnt2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_bufpnt2_bits_t) == 2U, dspic33_ecan_bufpnt2_bits_t_size);
typedef struct {
    uint16_t F8BP : 4;
    uint16_t F9BP : 4;
    uint16_t F10BP : 4;
    uint16_t F11BP : 4;
} dspic33_ecan_bufpnt3_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_bufpnt3_bits_t) == 2U, dspic33_ecan_bufpnt3_bits_t_size);
typedef struct {
    uint16_t F12BP : 4;
    uint16_t F13BP : 4;
    uint16_t F14BP : 4;
    uint16_t F15BP : 4;
} dspic33_ecan_bufpnt4_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_bufpnt4_bits_t) == 2U, dspic33_ecan_bufpnt4_bits_t_size);
typedef struct {
    uint16_t RXOVF0 : 1;
    uint16_t RXOVF1 : 1;
    uint16_t RXOVF2 : 1;
    uint16_t RXOVF3 : 1;
    uint16_t RXOVF4 : 1;
    uint16_t RXOVF5 : 1;
    uint16_t RXOVF6 : 1;
    uint16_t RXOVF7 : 1;
    uint16_t RXOVF8 : 1;
    uint16_t RXOVF9 : 1;
    uint16_t RXOVF10 : 1;
    uint16_t RXOVF11 : 1;
    uint16_t RXOVF12 : 1;
    uint16_t RXOVF13 : 1;
    uint16_t RXOVF14 : 1;
    uint16_t RXOVF15 : 1;
} dspic33_ecan_rxovf1_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxovf1_bits_t) == 2U, dspic33_ecan_rxovf1_bits_t_size);
typedef struct {
    uint16_t RXOVF16 : 1;
    uint16_t RXOVF17 : 1;
    uint16_t RXOVF18 : 1;
    uint16_t RXOVF19 : 1;
    uint16_t RXOVF20 : 1;
    uint16_t RXOVF21 : 1;
    uint16_t RXOVF22 : 1;
    uint16_t RXOVF23 : 1;
    uint16_t RXOVF24 : 1;
    uint16_t RXOVF25 : 1;
    uint16_t RXOVF26 : 1;
    uint16_t RXOVF27 : 1;
    uint16_t RXOVF28 : 1;
    uint16_t RXOVF29 : 1;
    uint16_t RXOVF30 : 1;
    uint16_t RXOVF31 : 1;
} dspic33_ecan_rxovf2_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxovf2_bits_t) == 2U, dspic33_ecan_rxovf2_bits_t_size);
typedef struct {
    uint16_t TX0PRI : 2;
    uint16_t RTREN0 : 1;
    uint16_t TXREQ0 : 1;
    uint16_t TXERR0 : 1;
    uint16_t TXLARB0 : 1;
    uint16_t TXABT0 : 1;
    uint16_t TXEN0 : 1;
    uint16_t TX1PRI : 2;
    uint16_t RTREN1 : 1;
    uint16_t TXREQ1 : 1;
    uint16_t TXERR1 : 1;
    uint16_t TXLARB1 : 1;
    uint16_t TXABT1 : 1;
    uint16_t TXEN1 : 1;
} dspic33_ecan_tr01con_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_tr01con_bits_t) == 2U, dspic33_ecan_tr01con_bits_t_size);
typedef struct {
    uint16_t EID_17_16 : 2;
    uint16_t : 1;
    uint16_t MIDE : 1;
    uint16_t : 1;
    uint16_t SID_10_0 : 11;
} dspic33_ecan_rxm_sid_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxm_sid_bits_t) == 2U, dspic33_ecan_rxm_sid_bits_t_size);
typedef struct {
    uint16_t TX2PRI : 2;
    uint16_t RTREN2 : 1;
    uint16_t TXREQ2 : 1;
    uint16_t TXERR2 : 1;
    uint16_t TXLARB2 : 1;
    uint16_t TXABT2 : 1;
    uint16_t TXEN2 : 1;
    uint16_t TX3PRI : 2;
    uint16_t RTREN3 : 1;
    uint16_t TXREQ3 : 1;
    uint16_t TXERR3 : 1;
    uint16_t TXLARB3 : 1;
    uint16_t TXABT3 : 1;
    uint16_t TXEN3 : 1;
} dspic33_ecan_tr23con_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_tr23con_bits_t) == 2U, dspic33_ecan_tr23con_bits_t_size);
typedef struct {
    uint16_t EID_15_0 : 16;
} dspic33_ecan_rxm_eid_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxm_eid_bits_t) == 2U, dspic33_ecan_rxm_eid_bits_t_size);
typedef struct {
    uint16_t TX4PRI : 2;
    uint16_t RTREN4 : 1;
    uint16_t TXREQ4 : 1;
    uint16_t TXERR4 : 1;
    uint16_t TXLARB4 : 1;
    uint16_t TXABT4 : 1;
    uint16_t TXEN4 : 1;
    uint16_t TX5PRI : 2;
    uint16_t RTREN5 : 1;
    uint16_t TXREQ5 : 1;
    uint16_t TXERR5 : 1;
    uint16_t TXLARB5 : 1;
    uint16_t TXABT5 : 1;
    uint16_t TXEN5 : 1;
} dspic33_ecan_tr45con_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_tr45con_bits_t) == 2U, dspic33_ecan_tr45con_bits_t_size);
typedef struct {
    uint16_t TX6PRI : 2;
    uint16_t RTREN6 : 1;
    uint16_t TXREQ6 : 1;
    uint16_t TXERR6 : 1;
    uint16_t TXLARB6 : 1;
    uint16_t TXABT6 : 1;
    uint16_t TXEN6 : 1;
    uint16_t TX7PRI : 2;
    uint16_t RTREN7 : 1;
    uint16_t TXREQ7 : 1;
    uint16_t TXERR7 : 1;
    uint16_t TXLARB7 : 1;
    uint16_t TXABT7 : 1;
    uint16_t TXEN7 : 1;
} dspic33_ecan_tr67con_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_tr67con_bits_t) == 2U, dspic33_ecan_tr67con_bits_t_size);
typedef struct {
    uint16_t DATA : 16;
} dspic33_ecan_rxd_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxd_bits_t) == 2U, dspic33_ecan_rxd_bits_t_size);
typedef struct {
    uint16_t EID_17_16 : 2;
    uint16_t : 1;
    uint16_t EXIDE : 1;
    uint16_t : 1;
    uint16_t SID_10_0 : 11;
} dspic33_ecan_rxf_sid_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxf_sid_bits_t) == 2U, dspic33_ecan_rxf_sid_bits_t_size);
typedef struct {
    uint16_t DATA : 16;
} dspic33_ecan_txd_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_txd_bits_t) == 2U, dspic33_ecan_txd_bits_t_size);
typedef struct {
    uint16_t EID_15_0 : 16;
} dspic33_ecan_rxf_eid_bits_t;
DSPIC33_ECAN_STATIC_ASSERT(sizeof(dspic33_ecan_rxf_eid_bits_t) == 2U, dspic33_ecan_rxf_eid_bits_t_size);
#ifndef DSPIC33_ECAN_C1_BASE
#define DSPIC33_ECAN_C1_BASE DSPIC33_ECAN_C1_BASE
#endif
#ifdef DSPIC33_ECAN_C1_BASE
#define C1CTRL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x000U))
#define C1CTRL1bits (*(volatile dspic33_ecan_ctrl1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x000U))
#define C1CTRL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x002U))
#define C1CTRL2bits (*(volatile dspic33_ecan_ctrl2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x002U))
#define C1VEC (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x004U))
#define C1VECbits (*(const volatile dspic33_ecan_vec_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x004U))
#define C1FCTRL (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x006U))
#define C1FCTRLbits (*(volatile dspic33_ecan_fctrl_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x006U))
#define C1FIFO (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x008U))
#define C1FIFObits (*(const volatile dspic33_ecan_fifo_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x008U))
#define C1INTF (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00AU))
#define C1INTFbits (*(const volatile dspic33_ecan_intf_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00AU))
#define C1INTE (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00CU))
#define C1INTEbits (*(volatile dspic33_ecan_inte_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00CU))
#define C1EC (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00EU))
#define C1ECbits (*(const volatile dspic33_ecan_ec_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x00EU))
#define C1CFG1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x010U))
#define C1CFG1bits (*(volatile dspic33_ecan_cfg1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x010U))
#define C1CFG2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x012U))
#define C1CFG2bits (*(volatile dspic33_ecan_cfg2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x012U))
#define C1FEN1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x014U))
#define C1FEN1bits (*(volatile dspic33_ecan_fen1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x014U))
#define C1FMSKSEL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x018U))
#define C1FMSKSEL1bits (*(volatile dspic33_ecan_fmsksel1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x018U))
#define C1FMSKSEL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x01AU))
#define C1FMSKSEL2bits (*(volatile dspic33_ecan_fmsksel2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x01AU))
#define C1RXFUL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x020U))
#define C1RXFUL1bits (*(const volatile dspic33_ecan_rxful1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x020U))
#define C1BUFPNT1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x020U))
#define C1BUFPNT1bits (*(volatile dspic33_ecan_bufpnt1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x020U))
#define C1RXFUL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x022U))
#define C1RXFUL2bits (*(const volatile dspic33_ecan_rxful2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x022U))
#define C1BUFPNT2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x022U))
#define C1BUFPNT2bits (*(volatile dspic33_ecan_bufpnt2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x022U))
#define C1BUFPNT3 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x024U))
#define C1BUFPNT3bits (*(volatile dspic33_ecan_bufpnt3_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x024U))
#define C1BUFPNT4 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x026U))
#define C1BUFPNT4bits (*(volatile dspic33_ecan_bufpnt4_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x026U))
#define C1RXOVF1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x028U))
#define C1RXOVF1bits (*(const volatile dspic33_ecan_rxovf1_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x028U))
#define C1RXOVF2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x02AU))
#define C1RXOVF2bits (*(const volatile dspic33_ecan_rxovf2_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x02AU))
#define C1TR01CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x030U))
#define C1TR01CONbits (*(volatile dspic33_ecan_tr01con_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x030U))
#define C1RXM0SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x030U))
#define C1RXM0SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x030U))
#define C1TR23CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x032U))
#define C1TR23CONbits (*(volatile dspic33_ecan_tr23con_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x032U))
#define C1RXM0EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x032U))
#define C1RXM0EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x032U))
#define C1TR45CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x034U))
#define C1TR45CONbits (*(volatile dspic33_ecan_tr45con_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x034U))
#define C1RXM1SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x034U))
#define C1RXM1SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x034U))
#define C1TR67CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x036U))
#define C1TR67CONbits (*(volatile dspic33_ecan_tr67con_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x036U))
#define C1RXM1EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x036U))
#define C1RXM1EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x036U))
#define C1RXM2SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x038U))
#define C1RXM2SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x038U))
#define C1RXM2EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x03AU))
#define C1RXM2EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x03AU))
#define C1RXD (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x040U))
#define C1RXDbits (*(volatile dspic33_ecan_rxd_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x040U))
#define C1RXF0SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x040U))
#define C1RXF0SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x040U))
#define C1TXD (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x042U))
#define C1TXDbits (*(volatile dspic33_ecan_txd_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x042U))
#define C1RXF0EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x042U))
#define C1RXF0EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x042U))
#define C1RXF1SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x044U))
#define C1RXF1SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x044U))
#define C1RXF1EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x046U))
#define C1RXF1EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x046U))
#define C1RXF2SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x048U))
#define C1RXF2SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x048U))
#define C1RXF2EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04AU))
#define C1RXF2EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04AU))
#define C1RXF3SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04CU))
#define C1RXF3SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04CU))
#define C1RXF3EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04EU))
#define C1RXF3EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x04EU))
#define C1RXF4SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x050U))
#define C1RXF4SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x050U))
#define C1RXF4EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x052U))
#define C1RXF4EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x052U))
#define C1RXF5SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x054U))
#define C1RXF5SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x054U))
#define C1RXF5EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x056U))
#define C1RXF5EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x056U))
#define C1RXF6SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x058U))
#define C1RXF6SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x058U))
#define C1RXF6EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05AU))
#define C1RXF6EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05AU))
#define C1RXF7SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05CU))
#define C1RXF7SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05CU))
#define C1RXF7EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05EU))
#define C1RXF7EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x05EU))
#define C1RXF8SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x060U))
#define C1RXF8SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x060U))
#define C1RXF8EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x062U))
#define C1RXF8EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x062U))
#define C1RXF9SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x064U))
#define C1RXF9SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x064U))
#define C1RXF9EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x066U))
#define C1RXF9EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x066U))
#define C1RXF10SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x068U))
#define C1RXF10SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x068U))
#define C1RXF10EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06AU))
#define C1RXF10EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06AU))
#define C1RXF11SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06CU))
#define C1RXF11SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06CU))
#define C1RXF11EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06EU))
#define C1RXF11EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x06EU))
#define C1RXF12SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x070U))
#define C1RXF12SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x070U))
#define C1RXF12EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x072U))
#define C1RXF12EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x072U))
#define C1RXF13SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x074U))
#define C1RXF13SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x074U))
#define C1RXF13EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x076U))
#define C1RXF13EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x076U))
#define C1RXF14SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x078U))
#define C1RXF14SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x078U))
#define C1RXF14EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07AU))
#define C1RXF14EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07AU))
#define C1RXF15SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07CU))
#define C1RXF15SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07CU))
#define C1RXF15EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07EU))
#define C1RXF15EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C1_BASE + 0x07EU))
#endif
#ifndef DSPIC33_ECAN_C2_BASE
#define DSPIC33_ECAN_C2_BASE DSPIC33_ECAN_C2_BASE
#endif
#ifdef DSPIC33_ECAN_C2_BASE
#define C2CTRL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x000U))
#define C2CTRL1bits (*(volatile dspic33_ecan_ctrl1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x000U))
#define C2CTRL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x002U))
#define C2CTRL2bits (*(volatile dspic33_ecan_ctrl2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x002U))
#define C2VEC (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x004U))
#define C2VECbits (*(const volatile dspic33_ecan_vec_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x004U))
#define C2FCTRL (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x006U))
#define C2FCTRLbits (*(volatile dspic33_ecan_fctrl_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x006U))
#define C2FIFO (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x008U))
#define C2FIFObits (*(const volatile dspic33_ecan_fifo_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x008U))
#define C2INTF (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00AU))
#define C2INTFbits (*(const volatile dspic33_ecan_intf_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00AU))
#define C2INTE (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00CU))
#define C2INTEbits (*(volatile dspic33_ecan_inte_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00CU))
#define C2EC (*(const volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00EU))
#define C2ECbits (*(const volatile dspic33_ecan_ec_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x00EU))
#define C2CFG1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x010U))
#define C2CFG1bits (*(volatile dspic33_ecan_cfg1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x010U))
#define C2CFG2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x012U))
#define C2CFG2bits (*(volatile dspic33_ecan_cfg2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x012U))
#define C2FEN1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x014U))
#define C2FEN1bits (*(volatile dspic33_ecan_fen1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x014U))
#define C2FMSKSEL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x018U))
#define C2FMSKSEL1bits (*(volatile dspic33_ecan_fmsksel1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x018U))
#define C2FMSKSEL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x01AU))
#define C2FMSKSEL2bits (*(volatile dspic33_ecan_fmsksel2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x01AU))
#define C2RXFUL1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x020U))
#define C2RXFUL1bits (*(const volatile dspic33_ecan_rxful1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x020U))
#define C2BUFPNT1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x020U))
#define C2BUFPNT1bits (*(volatile dspic33_ecan_bufpnt1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x020U))
#define C2RXFUL2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x022U))
#define C2RXFUL2bits (*(const volatile dspic33_ecan_rxful2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x022U))
#define C2BUFPNT2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x022U))
#define C2BUFPNT2bits (*(volatile dspic33_ecan_bufpnt2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x022U))
#define C2BUFPNT3 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x024U))
#define C2BUFPNT3bits (*(volatile dspic33_ecan_bufpnt3_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x024U))
#define C2BUFPNT4 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x026U))
#define C2BUFPNT4bits (*(volatile dspic33_ecan_bufpnt4_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x026U))
#define C2RXOVF1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x028U))
#define C2RXOVF1bits (*(const volatile dspic33_ecan_rxovf1_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x028U))
#define C2RXOVF2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x02AU))
#define C2RXOVF2bits (*(const volatile dspic33_ecan_rxovf2_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x02AU))
#define C2TR01CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x030U))
#define C2TR01CONbits (*(volatile dspic33_ecan_tr01con_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x030U))
#define C2RXM0SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x030U))
#define C2RXM0SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x030U))
#define C2TR23CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x032U))
#define C2TR23CONbits (*(volatile dspic33_ecan_tr23con_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x032U))
#define C2RXM0EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x032U))
#define C2RXM0EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x032U))
#define C2TR45CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x034U))
#define C2TR45CONbits (*(volatile dspic33_ecan_tr45con_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x034U))
#define C2RXM1SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x034U))
#define C2RXM1SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x034U))
#define C2TR67CON (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x036U))
#define C2TR67CONbits (*(volatile dspic33_ecan_tr67con_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x036U))
#define C2RXM1EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x036U))
#define C2RXM1EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x036U))
#define C2RXM2SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x038U))
#define C2RXM2SIDbits (*(volatile dspic33_ecan_rxm_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x038U))
#define C2RXM2EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x03AU))
#define C2RXM2EIDbits (*(volatile dspic33_ecan_rxm_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x03AU))
#define C2RXD (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x040U))
#define C2RXDbits (*(volatile dspic33_ecan_rxd_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x040U))
#define C2RXF0SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x040U))
#define C2RXF0SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x040U))
#define C2TXD (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x042U))
#define C2TXDbits (*(volatile dspic33_ecan_txd_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x042U))
#define C2RXF0EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x042U))
#define C2RXF0EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x042U))
#define C2RXF1SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x044U))
#define C2RXF1SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x044U))
#define C2RXF1EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x046U))
#define C2RXF1EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x046U))
#define C2RXF2SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x048U))
#define C2RXF2SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x048U))
#define C2RXF2EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04AU))
#define C2RXF2EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04AU))
#define C2RXF3SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04CU))
#define C2RXF3SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04CU))
#define C2RXF3EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04EU))
#define C2RXF3EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x04EU))
#define C2RXF4SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x050U))
#define C2RXF4SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x050U))
#define C2RXF4EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x052U))
#define C2RXF4EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x052U))
#define C2RXF5SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x054U))
#define C2RXF5SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x054U))
#define C2RXF5EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x056U))
#define C2RXF5EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x056U))
#define C2RXF6SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x058U))
#define C2RXF6SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x058U))
#define C2RXF6EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05AU))
#define C2RXF6EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05AU))
#define C2RXF7SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05CU))
#define C2RXF7SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05CU))
#define C2RXF7EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05EU))
#define C2RXF7EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x05EU))
#define C2RXF8SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x060U))
#define C2RXF8SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x060U))
#define C2RXF8EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x062U))
#define C2RXF8EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x062U))
#define C2RXF9SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x064U))
#define C2RXF9SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x064U))
#define C2RXF9EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x066U))
#define C2RXF9EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x066U))
#define C2RXF10SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x068U))
#define C2RXF10SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x068U))
#define C2RXF10EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06AU))
#define C2RXF10EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06AU))
#define C2RXF11SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06CU))
#define C2RXF11SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06CU))
#define C2RXF11EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06EU))
#define C2RXF11EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x06EU))
#define C2RXF12SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x070U))
#define C2RXF12SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x070U))
#define C2RXF12EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x072U))
#define C2RXF12EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x072U))
#define C2RXF13SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x074U))
#define C2RXF13SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x074U))
#define C2RXF13EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x076U))
#define C2RXF13EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x076U))
#define C2RXF14SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x078U))
#define C2RXF14SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x078U))
#define C2RXF14EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07AU))
#define C2RXF14EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07AU))
#define C2RXF15SID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07CU))
#define C2RXF15SIDbits (*(volatile dspic33_ecan_rxf_sid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07CU))
#define C2RXF15EID (*(volatile uint16_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07EU))
#define C2RXF15EIDbits (*(volatile dspic33_ecan_rxf_eid_bits_t *)((uintptr_t)DSPIC33_ECAN_C2_BASE + 0x07EU))
#endif
#endif

#ifdef __cplusplus
}
#endif

#endif /* DSPIC33_ECAN_H */
