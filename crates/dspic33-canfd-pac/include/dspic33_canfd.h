/* Microchip dsPIC33 CAN FD Protocol Module: registers and message layouts.
 * CAN FD controller of the dsPIC33C family. 31 FIFOs, each configurable for transmission or reception, a
 * transmit queue that sends by message ID, a transmit event FIFO, and 32 acceptance filters with one mask each.
 * Messages lie in system RAM; hardware lays out event FIFO, queue and FIFOs one behind the other from one base
 * address and hands out the address of the object to use next. The manual gives no address. All offsets here are
 * those of the MCP251xFD, a sister controller with the same register set and the full 31 FIFOs and 32 filters.
 * Known dsPIC33C devices implement fewer FIFOs, and there the filter registers stand at lower addresses, right
 * behind the last FIFO: with 7 FIFOs the filter control registers begin at 0x0B0 instead of 0x1D0. On such a
 * device only the registers from 0x000 up to the last implemented FIFO (0x0AF with 7 FIFOs) stand where this
 * description puts them.
 * Described after CAN Flexible Data-Rate (FD) Protocol Module, Microchip Technology Incorporated, revision C.
 * Generated from the description of the controller; changes belong there.
 * C99 or C++11. A field FIELD of a register REG has DSPIC33_CANFD_REG_FIELD_Pos, _Msk, _Width and _Access; a
 * field that is repeated in its register takes the number of the lane, counted from 0, as an argument.
 * Access codes: rw, ro, wo; w1c and w0c are flags cleared by writing 1 or 0; w1s is a request made by writing 1;
 * rwhc a request that 0 withdraws; rwh is changed by hardware too; wclr is cleared or preset by any write; +rc
 * and +rs are cleared or set by a read, @n of byte n; a condition for writing stands behind the colon.
 * Define DSPIC33_CANFD_ASSERT(condition) to have ranges and indices checked at run time.
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef DSPIC33_CANFD_H
#define DSPIC33_CANFD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__cplusplus)
#define DSPIC33_CANFD_STATIC_ASSERT(condition, name) static_assert(condition, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define DSPIC33_CANFD_STATIC_ASSERT(condition, name) _Static_assert(condition, #name)
#else
#define DSPIC33_CANFD_STATIC_ASSERT(condition, name) typedef char name[(condition) ? 1 : -1]
#endif

#ifndef DSPIC33_CANFD_ASSERT
#define DSPIC33_CANFD_ASSERT(condition) ((void)0)
#endif

/* A register that software can only read. C++ wants every const member initialized. */
#ifdef __cplusplus
#define DSPIC33_CANFD_READ_ONLY volatile
#else
#define DSPIC33_CANFD_READ_ONLY volatile const
#endif

/* Values of CONH.REQOP, CONH.OPMOD.
 * The eight modes of operation, as requested and as reached.
 * Register 3-2; §4.0 p.53
 */
/* On the bus with CAN FD and CAN 2.0 frames. */
#define DSPIC33_CANFD_OPERATION_MODE_NORMAL_CAN_FD 0U
/* Off the bus with CxTX recessive; the mode to be in before the device goes to Sleep. */
#define DSPIC33_CANFD_OPERATION_MODE_DISABLE 1U
/* Transmit signal fed back inside, CxTX high, CxRX disconnected. */
#define DSPIC33_CANFD_OPERATION_MODE_INTERNAL_LOOPBACK 2U
/* Receives without acknowledging, without error flags and without sending; transmission requests are ignored,
 * the error counters stand still.
 */
#define DSPIC33_CANFD_OPERATION_MODE_LISTEN_ONLY 3U
/* Off the bus, protected fields writable; the mode after reset. */
#define DSPIC33_CANFD_OPERATION_MODE_CONFIGURATION 4U
/* Transmit signal fed back inside and visible on CxTX; CxRX disconnected. */
#define DSPIC33_CANFD_OPERATION_MODE_EXTERNAL_LOOPBACK 5U
/* On the bus with CAN 2.0 frames only; CAN FD frames may be answered with error frames. */
#define DSPIC33_CANFD_OPERATION_MODE_NORMAL_CAN_2_0 6U
/* Receives and acknowledges, but sends no data, remote, error or overload frames; the error counters do not
 * count up.
 */
#define DSPIC33_CANFD_OPERATION_MODE_RESTRICTED_OPERATION 7U

/* Values of TXQCONH.PLSIZE, FIFOCONH.PLSIZE.
 * Data bytes reserved in every message object of a FIFO or of the queue.
 * Register 3-30; Register 3-33
 */
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_8 0U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_12 1U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_16 2U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_20 3U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_24 4U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_32 5U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_48 6U
#define DSPIC33_CANFD_PAYLOAD_SIZE_BYTES_64 7U

/* Values of TXQCONH.TXAT, FIFOCONH.TXAT.
 * How often a failed transmission is repeated; used only while CONH.RTXAT is set.
 * Register 3-30; Register 3-33; §6.9
 */
/* One attempt; lost arbitration counts as failure. */
#define DSPIC33_CANFD_RETRANSMISSION_ATTEMPTS_DISABLED 0U
/* Three retransmissions after errors; lost arbitration does not use one up. The count starts anew when another
 * FIFO or the queue is chosen in between, or a message is received.
 */
#define DSPIC33_CANFD_RETRANSMISSION_ATTEMPTS_THREE 1U
/* Repeated until sent. */
#define DSPIC33_CANFD_RETRANSMISSION_ATTEMPTS_UNLIMITED_FIRST 2U
#define DSPIC33_CANFD_RETRANSMISSION_ATTEMPTS_UNLIMITED_LAST 3U

/* Number of data bytes of a frame. In a CAN 2.0 frame the codes above 8 all mean 8 bytes; the numbers here are
 * those of a CAN FD frame.
 * Table 2-1
 */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_0 0U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_1 1U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_2 2U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_3 3U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_4 4U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_5 5U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_6 6U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_7 7U
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_8 8U
/* 12 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_12 9U
/* 16 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_16 10U
/* 20 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_20 11U
/* 24 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_24 12U
/* 32 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_32 13U
/* 48 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_48 14U
/* 64 bytes in a CAN FD frame, 8 in a CAN 2.0 frame. */
#define DSPIC33_CANFD_DATA_LENGTH_CODE_BYTES_64 15U

/* Values of VECL.FILHIT.
 * Number of a filter.
 * Register 3-13; Table 9-1
 */
/* Filter n. */
#define DSPIC33_CANFD_FILTER_NUMBER_FILTER_FIRST 0U
#define DSPIC33_CANFD_FILTER_NUMBER_FILTER_LAST 31U

/* Error state of the node that sends a frame, as ESI shows it.
 * Table 6-1; §9.1
 */
#define DSPIC33_CANFD_ERROR_STATE_ERROR_ACTIVE 0U
#define DSPIC33_CANFD_ERROR_STATE_ERROR_PASSIVE 1U

/* Frame format as FDF shows it.
 * §6.1; §9.1
 */
#define DSPIC33_CANFD_FRAME_FORMAT_CAN_2_0 0U
#define DSPIC33_CANFD_FRAME_FORMAT_CAN_FD 1U

/* Bit rate of the data phase of a CAN FD frame as BRS shows it.
 * §6.1; §9.1
 */
#define DSPIC33_CANFD_DATA_PHASE_RATE_NOMINAL 0U
#define DSPIC33_CANFD_DATA_PHASE_RATE_DATA 1U

/* Identifier format as IDE shows it.
 * §6.1; §9.1
 */
#define DSPIC33_CANFD_IDENTIFIER_FORMAT_BASE 0U
#define DSPIC33_CANFD_IDENTIFIER_FORMAT_EXTENDED 1U

/* Values of CONL.WFT.
 * Register 3-1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_L_WFT_T00_FILTER 0U
#define DSPIC33_CANFD_CON_L_WFT_T01_FILTER 1U
#define DSPIC33_CANFD_CON_L_WFT_T10_FILTER 2U
#define DSPIC33_CANFD_CON_L_WFT_T11_FILTER 3U

/* Values of CONL.CLKSEL.
 * Register 3-1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_L_CLKSEL_CAN_CLOCK_GENERATOR 0U
#define DSPIC33_CANFD_CON_L_CLKSEL_AUXILIARY_CLOCK 1U

/* Values of CONL.PXEDIS.
 * Register 3-1; external: mcp251xfd (offset)
 */
/* Detection enabled: the module goes to bus integration, the error counters do not change. */
#define DSPIC33_CANFD_CON_L_PXEDIS_BUS_INTEGRATION 0U
/* Detection disabled: treated as a form error. */
#define DSPIC33_CANFD_CON_L_PXEDIS_FORM_ERROR 1U

/* Values of CONL.ISOCRCEN.
 * Register 3-1; external: mcp251xfd (offset)
 */
/* No stuff count in the CRC field, CRC register starts with zeros. */
#define DSPIC33_CANFD_CON_L_ISOCRCEN_NON_ISO 0U
/* Stuff count in the CRC field, CRC register starts with a non-zero vector. */
#define DSPIC33_CANFD_CON_L_ISOCRCEN_ISO_11898_1 1U

/* Values of CONL.DNCNT.
 * Register 3-1; external: mcp251xfd (offset)
 */
/* Data bytes are not compared. */
#define DSPIC33_CANFD_CON_L_DNCNT_NONE 0U
/* The first n data bits are compared with EID[0] to EID[n-1]. */
#define DSPIC33_CANFD_CON_L_DNCNT_BITS_FIRST 1U
#define DSPIC33_CANFD_CON_L_DNCNT_BITS_LAST 18U

/* Values of CONH.TXBWS.
 * Register 3-2; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_H_TXBWS_NO_DELAY 0U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_2 1U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_4 2U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_8 3U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_16 4U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_32 5U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_64 6U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_128 7U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_256 8U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_512 9U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_1024 10U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_2048 11U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_4096_FIRST 12U
#define DSPIC33_CANFD_CON_H_TXBWS_BIT_TIMES_4096_LAST 15U

/* Values of CONH.SERRLOM.
 * Register 3-2; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_H_SERRLOM_RESTRICTED_OPERATION 0U
#define DSPIC33_CANFD_CON_H_SERRLOM_LISTEN_ONLY 1U

/* Values of CONH.ESIGM.
 * Register 3-2; external: mcp251xfd (offset)
 */
/* ESI shows the error state of this controller; ESI in the message object is ignored. */
#define DSPIC33_CANFD_CON_H_ESIGM_ERROR_STATE 0U
/* ESI is recessive if the ESI bit of the message object is set or the controller is error passive. */
#define DSPIC33_CANFD_CON_H_ESIGM_GATEWAY 1U

/* Values of CONH.RTXAT.
 * Register 3-2; external: mcp251xfd (offset)
 */
/* Unlimited attempts; TXAT of the queue and the FIFOs is ignored. */
#define DSPIC33_CANFD_CON_H_RTXAT_UNLIMITED 0U
/* TXAT of the queue or FIFO gives the limit. */
#define DSPIC33_CANFD_CON_H_RTXAT_RESTRICTED 1U

/* Values of TDCH.TDCMOD.
 * Register 3-8; external: mcp251xfd (offset)
 */
/* No compensation. */
#define DSPIC33_CANFD_TDC_H_TDCMOD_DISABLED 0U
/* Does not measure; the secondary sample point is TDCV + TDCO. */
#define DSPIC33_CANFD_TDC_H_TDCMOD_MANUAL 1U
/* Measures the delay and adds TDCO. */
#define DSPIC33_CANFD_TDC_H_TDCMOD_AUTOMATIC_FIRST 2U
#define DSPIC33_CANFD_TDC_H_TDCMOD_AUTOMATIC_LAST 3U

/* Values of TSCONH.TSRES.
 * Register 3-12; §11.0 p.108; external: mcp251xfd (offset)
 */
/* Sample point of the start-of-frame bit. */
#define DSPIC33_CANFD_TSCON_H_TSRES_START_OF_FRAME 0U
/* Sample point of the bit that follows FDF. */
#define DSPIC33_CANFD_TSCON_H_TSRES_AFTER_FDF 1U

/* Values of TSCONH.TSEOF.
 * Register 3-12; §11.0 p.108; external: mcp251xfd (offset)
 */
/* At the sample point of start of frame; CAN FD frames as TSRES says. */
#define DSPIC33_CANFD_TSCON_H_TSEOF_BEGINNING 0U
/* Received frames at the last but one bit of end of frame, transmitted frames at the end of it, if no error
 * occurred.
 */
#define DSPIC33_CANFD_TSCON_H_TSEOF_VALID 1U

/* Values of VECL.ICODE.
 * Register 3-13; §12.4.1; external: mcp251xfd (offset)
 */
/* FIFO n, where 0 is the transmit queue (TFIFn or RFIFn is set; 0 only TFIF0). */
#define DSPIC33_CANFD_VEC_L_ICODE_FIFO_FIRST 0U
#define DSPIC33_CANFD_VEC_L_ICODE_FIFO_LAST 31U
/* No interrupt. */
#define DSPIC33_CANFD_VEC_L_ICODE_NONE 64U
/* CAN bus error (CERRIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_BUS_ERROR 65U
/* Wake-up (WAKIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_WAKE_UP 66U
/* Receive FIFO overflow (any bit in RXOVIFL/H). */
#define DSPIC33_CANFD_VEC_L_ICODE_RECEIVE_OVERFLOW 67U
/* A FIFO presented an illegal address to the system (SERRIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_ADDRESS_ERROR 68U
/* Receive assembly buffer overflow or transmit assembly buffer underflow (SERRIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_MESSAGE_BUFFER 69U
/* Time Base Counter overflow (TBCIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_TIMER_OVERFLOW 70U
/* Mode change (MODIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_MODE_CHANGE 71U
/* Invalid message (IVMIF). */
#define DSPIC33_CANFD_VEC_L_ICODE_INVALID_MESSAGE 72U
/* Transmit event FIFO (any bit in TEFSTA). */
#define DSPIC33_CANFD_VEC_L_ICODE_TRANSMIT_EVENT 73U
/* Transmit attempts exhausted (any bit in TXATIFL/H). */
#define DSPIC33_CANFD_VEC_L_ICODE_TRANSMIT_ATTEMPT 74U

/* Values of VECH.RXCODE.
 * Register 3-14; §12.4.1; external: mcp251xfd (offset)
 */
/* FIFO n (RFIFn is set). */
#define DSPIC33_CANFD_VEC_H_RXCODE_FIFO_FIRST 1U
#define DSPIC33_CANFD_VEC_H_RXCODE_FIFO_LAST 31U
/* No receive interrupt. */
#define DSPIC33_CANFD_VEC_H_RXCODE_NONE 64U

/* Values of VECH.TXCODE.
 * Register 3-14; §12.4.1; external: mcp251xfd (offset)
 */
/* FIFO n, where 0 is the transmit queue (TFIFn is set). */
#define DSPIC33_CANFD_VEC_H_TXCODE_FIFO_FIRST 0U
#define DSPIC33_CANFD_VEC_H_TXCODE_FIFO_LAST 31U
/* No transmit interrupt. */
#define DSPIC33_CANFD_VEC_H_TXCODE_NONE 64U

/* Values of FLTCON.FBP.
 * Register 3-50; Register 3-51; §8.1; §8.2; external: mcp251xfd (offset); external: mcp251xfd_api (offset with
 * fewer FIFOs)
 */
/* Reserved: FIFO 0 is the transmit queue, which cannot receive. The value after reset; point to a FIFO before
 * enabling the filter.
 */
#define DSPIC33_CANFD_FLT_CON_FBP_TRANSMIT_QUEUE 0U
/* Stored in FIFO n. */
#define DSPIC33_CANFD_FLT_CON_FBP_FIFO_FIRST 1U
#define DSPIC33_CANFD_FLT_CON_FBP_FIFO_LAST 31U

/* Values of CANCLKCON.CANCLKSEL.
 * Register 5-1
 */
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_NONE 0U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_FVCO 1U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_FPLLO 2U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_FVCO_DIV_2 3U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_FVCO_DIV_3 4U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_FVCO_DIV_4 5U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_AFPLLO 6U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_AFVCO 7U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_AFVCO_DIV_2 8U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_AFVCO_DIV_3 9U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_AFVCO_DIV_4 10U

/* Values of FIFOCONL.TXEN.
 * Register 3-32; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_RECEIVE 0U
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_TRANSMIT 1U

/* Values of FLTOBJH.EXIDE.
 * Register 3-53 p.51; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_STANDARD 0U
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_EXTENDED 1U

/* Values of MASKH.MIDE.
 * Register 3-55 p.52; external: mcp251xfd (offset)
 */
/* Standard and extended frames match if the identifiers do. */
#define DSPIC33_CANFD_MASK_H_MIDE_EITHER 0U
/* Only the frame type that EXIDE names matches. */
#define DSPIC33_CANFD_MASK_H_MIDE_AS_EXIDE 1U

/* FIFO 1 to 31. */
typedef struct {
    volatile uint16_t FIFOCONL; /* CAN FIFO Control Register Low */
    volatile uint16_t FIFOCONH; /* CAN FIFO Control Register High */
    volatile uint16_t FIFOSTA; /* CAN FIFO Status Register */
    uint8_t RESERVED_006[2];
    DSPIC33_CANFD_READ_ONLY uint16_t FIFOUAL; /* CAN FIFO User Address Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t FIFOUAH; /* CAN FIFO User Address Register High */
} dspic33_canfd_fifo_t;

/* Filter objects and masks 0 to 31. */
typedef struct {
    volatile uint16_t FLTOBJL; /* CAN Filter Object Register Low */
    volatile uint16_t FLTOBJH; /* CAN Filter Object Register High */
    volatile uint16_t MASKL; /* CAN Mask Register Low */
    volatile uint16_t MASKH; /* CAN Mask Register High */
} dspic33_canfd_flt_t;

/* The register block. */
typedef struct dspic33_canfd_regs {
    volatile uint16_t CONL; /* CAN Control Register Low */
    volatile uint16_t CONH; /* CAN Control Register High */
    volatile uint16_t NBTCFGL; /* CAN Nominal Bit Time Configuration Register Low */
    volatile uint16_t NBTCFGH; /* CAN Nominal Bit Time Configuration Register High */
    volatile uint16_t DBTCFGL; /* CAN Data Bit Time Configuration Register Low */
    volatile uint16_t DBTCFGH; /* CAN Data Bit Time Configuration Register High */
    volatile uint16_t TDCL; /* CAN Transmitter Delay Compensation Register Low */
    volatile uint16_t TDCH; /* CAN Transmitter Delay Compensation Register High */
    volatile uint16_t TBCL; /* CAN Time Base Counter Register Low */
    volatile uint16_t TBCH; /* CAN Time Base Counter Register High */
    volatile uint16_t TSCONL; /* CAN Timestamp Control Register Low */
    volatile uint16_t TSCONH; /* CAN Timestamp Control Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t VECL; /* CAN Interrupt Code Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t VECH; /* CAN Interrupt Code Register High */
    volatile uint16_t INTL; /* CAN Interrupt Register Low */
    volatile uint16_t INTH; /* CAN Interrupt Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t RXIFL; /* CAN Receive Interrupt Status Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t RXIFH; /* CAN Receive Interrupt Status Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t TXIFL; /* CAN Transmit Interrupt Status Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t TXIFH; /* CAN Transmit Interrupt Status Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t RXOVIFL; /* CAN Receive Overflow Interrupt Status Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t RXOVIFH; /* CAN Receive Overflow Interrupt Status Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t TXATIFL; /* CAN Transmit Attempt Interrupt Status Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t TXATIFH; /* CAN Transmit Attempt Interrupt Status Register High */
    volatile uint16_t TXREQL; /* CAN Transmit Request Register Low */
    volatile uint16_t TXREQH; /* CAN Transmit Request Register High */
    DSPIC33_CANFD_READ_ONLY uint16_t TRECL; /* CAN Transmit/Receive Error Count Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t TRECH; /* CAN Transmit/Receive Error Count Register High */
    volatile uint16_t BDIAG0L; /* CAN Bus Diagnostics Register 0 Low */
    volatile uint16_t BDIAG0H; /* CAN Bus Diagnostics Register 0 High */
    volatile uint16_t BDIAG1L; /* CAN Bus Diagnostics Register 1 Low */
    volatile uint16_t BDIAG1H; /* CAN Bus Diagnostics Register 1 High */
    volatile uint16_t TEFCONL; /* CAN Transmit Event FIFO Control Register Low */
    volatile uint16_t TEFCONH; /* CAN Transmit Event FIFO Control Register High */
    volatile uint16_t TEFSTA; /* CAN Transmit Event FIFO Status Register */
    uint8_t RESERVED_046[2];
    DSPIC33_CANFD_READ_ONLY uint16_t TEFUAL; /* CAN Transmit Event FIFO User Address Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t TEFUAH; /* CAN Transmit Event FIFO User Address Register High */
    volatile uint16_t FIFOBAL; /* CAN Message Memory Base Address Register Low */
    volatile uint16_t FIFOBAH; /* CAN Message Memory Base Address Register High */
    volatile uint16_t TXQCONL; /* CAN Transmit Queue Control Register Low */
    volatile uint16_t TXQCONH; /* CAN Transmit Queue Control Register High */
    volatile uint16_t TXQSTA; /* CAN Transmit Queue Status Register */
    uint8_t RESERVED_056[2];
    DSPIC33_CANFD_READ_ONLY uint16_t TXQUAL; /* CAN Transmit Queue User Address Register Low */
    DSPIC33_CANFD_READ_ONLY uint16_t TXQUAH; /* CAN Transmit Queue User Address Register High */
    dspic33_canfd_fifo_t FIFO[31];
    volatile uint16_t FLTCON[16]; /* CAN Filter Control Registers */
    dspic33_canfd_flt_t FLT[32];
} dspic33_canfd_regs_t;

DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, CONL) == 0x000U, dspic33_canfd_at_CONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, CONH) == 0x002U, dspic33_canfd_at_CONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, NBTCFGL) == 0x004U, dspic33_canfd_at_NBTCFGL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, NBTCFGH) == 0x006U, dspic33_canfd_at_NBTCFGH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, DBTCFGL) == 0x008U, dspic33_canfd_at_DBTCFGL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, DBTCFGH) == 0x00AU, dspic33_canfd_at_DBTCFGH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TDCL) == 0x00CU, dspic33_canfd_at_TDCL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TDCH) == 0x00EU, dspic33_canfd_at_TDCH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TBCL) == 0x010U, dspic33_canfd_at_TBCL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TBCH) == 0x012U, dspic33_canfd_at_TBCH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TSCONL) == 0x014U, dspic33_canfd_at_TSCONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TSCONH) == 0x016U, dspic33_canfd_at_TSCONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, VECL) == 0x018U, dspic33_canfd_at_VECL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, VECH) == 0x01AU, dspic33_canfd_at_VECH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, INTL) == 0x01CU, dspic33_canfd_at_INTL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, INTH) == 0x01EU, dspic33_canfd_at_INTH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, RXIFL) == 0x020U, dspic33_canfd_at_RXIFL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, RXIFH) == 0x022U, dspic33_canfd_at_RXIFH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXIFL) == 0x024U, dspic33_canfd_at_TXIFL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXIFH) == 0x026U, dspic33_canfd_at_TXIFH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, RXOVIFL) == 0x028U, dspic33_canfd_at_RXOVIFL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, RXOVIFH) == 0x02AU, dspic33_canfd_at_RXOVIFH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXATIFL) == 0x02CU, dspic33_canfd_at_TXATIFL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXATIFH) == 0x02EU, dspic33_canfd_at_TXATIFH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXREQL) == 0x030U, dspic33_canfd_at_TXREQL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXREQH) == 0x032U, dspic33_canfd_at_TXREQH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TRECL) == 0x034U, dspic33_canfd_at_TRECL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TRECH) == 0x036U, dspic33_canfd_at_TRECH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, BDIAG0L) == 0x038U, dspic33_canfd_at_BDIAG0L);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, BDIAG0H) == 0x03AU, dspic33_canfd_at_BDIAG0H);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, BDIAG1L) == 0x03CU, dspic33_canfd_at_BDIAG1L);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, BDIAG1H) == 0x03EU, dspic33_canfd_at_BDIAG1H);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TEFCONL) == 0x040U, dspic33_canfd_at_TEFCONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TEFCONH) == 0x042U, dspic33_canfd_at_TEFCONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TEFSTA) == 0x044U, dspic33_canfd_at_TEFSTA);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TEFUAL) == 0x048U, dspic33_canfd_at_TEFUAL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TEFUAH) == 0x04AU, dspic33_canfd_at_TEFUAH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFOBAL) == 0x04CU, dspic33_canfd_at_FIFOBAL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFOBAH) == 0x04EU, dspic33_canfd_at_FIFOBAH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXQCONL) == 0x050U, dspic33_canfd_at_TXQCONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXQCONH) == 0x052U, dspic33_canfd_at_TXQCONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXQSTA) == 0x054U, dspic33_canfd_at_TXQSTA);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXQUAL) == 0x058U, dspic33_canfd_at_TXQUAL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, TXQUAH) == 0x05AU, dspic33_canfd_at_TXQUAH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[0].FIFOCONL) == 0x05CU, dspic33_canfd_at_FIFO_0__FIFOCONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[0].FIFOCONH) == 0x05EU, dspic33_canfd_at_FIFO_0__FIFOCONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[0].FIFOSTA) == 0x060U, dspic33_canfd_at_FIFO_0__FIFOSTA);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[0].FIFOUAL) == 0x064U, dspic33_canfd_at_FIFO_0__FIFOUAL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[0].FIFOUAH) == 0x066U, dspic33_canfd_at_FIFO_0__FIFOUAH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[1].FIFOCONL) == 0x068U, dspic33_canfd_at_FIFO_1__FIFOCONL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[1].FIFOCONH) == 0x06AU, dspic33_canfd_at_FIFO_1__FIFOCONH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[1].FIFOSTA) == 0x06CU, dspic33_canfd_at_FIFO_1__FIFOSTA);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[1].FIFOUAL) == 0x070U, dspic33_canfd_at_FIFO_1__FIFOUAL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FIFO[1].FIFOUAH) == 0x072U, dspic33_canfd_at_FIFO_1__FIFOUAH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLTCON[0]) == 0x1D0U, dspic33_canfd_at_FLTCON_0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLTCON[1]) == 0x1D2U, dspic33_canfd_at_FLTCON_1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[0].FLTOBJL) == 0x1F0U, dspic33_canfd_at_FLT_0__FLTOBJL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[0].FLTOBJH) == 0x1F2U, dspic33_canfd_at_FLT_0__FLTOBJH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[0].MASKL) == 0x1F4U, dspic33_canfd_at_FLT_0__MASKL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[0].MASKH) == 0x1F6U, dspic33_canfd_at_FLT_0__MASKH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[1].FLTOBJL) == 0x1F8U, dspic33_canfd_at_FLT_1__FLTOBJL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[1].FLTOBJH) == 0x1FAU, dspic33_canfd_at_FLT_1__FLTOBJH);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[1].MASKL) == 0x1FCU, dspic33_canfd_at_FLT_1__MASKL);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_regs_t, FLT[1].MASKH) == 0x1FEU, dspic33_canfd_at_FLT_1__MASKH);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_regs_t) == 0x2F0U, dspic33_canfd_span);

/* CONL: CAN Control Register Low.
 * Module enable, clock source, low-power behaviour and protocol options.
 * Contradictions of the manual: protected_fields.
 * Register 3-1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_L_OFFSET 0x000U
#define DSPIC33_CANFD_CON_L_RESET 0x0760U
#define DSPIC33_CANFD_CON_L_RESET_MASK 0xFFFFU
/* CON: Enables the CAN module. Access rw.
 * Contradictions of the manual: example_6_1_enable_bit.
 */
#define DSPIC33_CANFD_CON_L_CON_Pos 15U
#define DSPIC33_CANFD_CON_L_CON_Msk 0x8000U
#define DSPIC33_CANFD_CON_L_CON_Width 1U
#define DSPIC33_CANFD_CON_L_CON_Access "rw"
#define DSPIC33_CANFD_CON_L_CON_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_CON_Pos) & DSPIC33_CANFD_CON_L_CON_Msk))
static inline uint16_t dspic33_canfd_con_l_con_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_CON_Msk) >> DSPIC33_CANFD_CON_L_CON_Pos);
}
static inline uint16_t dspic33_canfd_con_l_con_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_CON_Msk) | DSPIC33_CANFD_CON_L_CON_SET(value));
}
/* SIDL: Stops the module while the device is in Idle mode (1) or lets it run on (0). Put the module into Disable
 * mode before entering Idle with this bit set. Access rw.
 * Register 3-1; §4.6.2
 */
#define DSPIC33_CANFD_CON_L_SIDL_Pos 13U
#define DSPIC33_CANFD_CON_L_SIDL_Msk 0x2000U
#define DSPIC33_CANFD_CON_L_SIDL_Width 1U
#define DSPIC33_CANFD_CON_L_SIDL_Access "rw"
#define DSPIC33_CANFD_CON_L_SIDL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_SIDL_Pos) & DSPIC33_CANFD_CON_L_SIDL_Msk))
static inline uint16_t dspic33_canfd_con_l_sidl_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_SIDL_Msk) >> DSPIC33_CANFD_CON_L_SIDL_Pos);
}
static inline uint16_t dspic33_canfd_con_l_sidl_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_SIDL_Msk) | DSPIC33_CANFD_CON_L_SIDL_SET(value));
}
/* BRSDIS: Disables bit rate switching for all frames (1), whatever BRS in the transmit message object says; with
 * 0 the object decides. Access rw.
 */
#define DSPIC33_CANFD_CON_L_BRSDIS_Pos 12U
#define DSPIC33_CANFD_CON_L_BRSDIS_Msk 0x1000U
#define DSPIC33_CANFD_CON_L_BRSDIS_Width 1U
#define DSPIC33_CANFD_CON_L_BRSDIS_Access "rw"
#define DSPIC33_CANFD_CON_L_BRSDIS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_BRSDIS_Pos) & DSPIC33_CANFD_CON_L_BRSDIS_Msk))
static inline uint16_t dspic33_canfd_con_l_brsdis_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_BRSDIS_Msk) >> DSPIC33_CANFD_CON_L_BRSDIS_Pos);
}
static inline uint16_t dspic33_canfd_con_l_brsdis_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_BRSDIS_Msk) | DSPIC33_CANFD_CON_L_BRSDIS_SET(value));
}
/* BUSY: The module is active (1) or inactive (0). Access ro. */
#define DSPIC33_CANFD_CON_L_BUSY_Pos 11U
#define DSPIC33_CANFD_CON_L_BUSY_Msk 0x0800U
#define DSPIC33_CANFD_CON_L_BUSY_Width 1U
#define DSPIC33_CANFD_CON_L_BUSY_Access "ro"
static inline uint16_t dspic33_canfd_con_l_busy_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_BUSY_Msk) >> DSPIC33_CANFD_CON_L_BUSY_Pos);
}
/* WFT: Time constant of the wake-up filter on CxRX. The times themselves are device parameters. Access rw.
 * Contradictions of the manual: wake_up_filter_modes.
 * Register 3-1; §5.2.3
 */
#define DSPIC33_CANFD_CON_L_WFT_Pos 9U
#define DSPIC33_CANFD_CON_L_WFT_Msk 0x0600U
#define DSPIC33_CANFD_CON_L_WFT_Width 2U
#define DSPIC33_CANFD_CON_L_WFT_Access "rw"
#define DSPIC33_CANFD_CON_L_WFT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_WFT_Pos) & DSPIC33_CANFD_CON_L_WFT_Msk))
static inline uint16_t dspic33_canfd_con_l_wft_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_WFT_Msk) >> DSPIC33_CANFD_CON_L_WFT_Pos);
}
static inline uint16_t dspic33_canfd_con_l_wft_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_WFT_Msk) | DSPIC33_CANFD_CON_L_WFT_SET(value));
}
/* WAKFIL: Switches the low-pass filter on CxRX on for wake-up. Access rw:config. A write has an effect only if
 * config (CONH.OPMOD == configuration).
 * Contradictions of the manual: wake_up_filter_modes.
 * Register 3-1; §5.2.3
 */
#define DSPIC33_CANFD_CON_L_WAKFIL_Pos 8U
#define DSPIC33_CANFD_CON_L_WAKFIL_Msk 0x0100U
#define DSPIC33_CANFD_CON_L_WAKFIL_Width 1U
#define DSPIC33_CANFD_CON_L_WAKFIL_Access "rw:config"
#define DSPIC33_CANFD_CON_L_WAKFIL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_WAKFIL_Pos) & DSPIC33_CANFD_CON_L_WAKFIL_Msk))
static inline uint16_t dspic33_canfd_con_l_wakfil_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_WAKFIL_Msk) >> DSPIC33_CANFD_CON_L_WAKFIL_Pos);
}
static inline uint16_t dspic33_canfd_con_l_wakfil_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_WAKFIL_Msk) | DSPIC33_CANFD_CON_L_WAKFIL_SET(value));
}
/* CLKSEL: Clock source of the module. Access rw:config. A write has an effect only if config (CONH.OPMOD ==
 * configuration).
 * Register 3-1; §5.1
 */
#define DSPIC33_CANFD_CON_L_CLKSEL_Pos 7U
#define DSPIC33_CANFD_CON_L_CLKSEL_Msk 0x0080U
#define DSPIC33_CANFD_CON_L_CLKSEL_Width 1U
#define DSPIC33_CANFD_CON_L_CLKSEL_Access "rw:config"
#define DSPIC33_CANFD_CON_L_CLKSEL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_CLKSEL_Pos) & DSPIC33_CANFD_CON_L_CLKSEL_Msk))
static inline uint16_t dspic33_canfd_con_l_clksel_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_CLKSEL_Msk) >> DSPIC33_CANFD_CON_L_CLKSEL_Pos);
}
static inline uint16_t dspic33_canfd_con_l_clksel_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_CLKSEL_Msk) | DSPIC33_CANFD_CON_L_CLKSEL_SET(value));
}
/* PXEDIS: Reaction to a recessive reserved bit behind a recessive FDF bit (protocol exception). Access
 * rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Contradictions of the manual: protocol_exception_wording.
 * Register 3-1; §5.2.2
 */
#define DSPIC33_CANFD_CON_L_PXEDIS_Pos 6U
#define DSPIC33_CANFD_CON_L_PXEDIS_Msk 0x0040U
#define DSPIC33_CANFD_CON_L_PXEDIS_Width 1U
#define DSPIC33_CANFD_CON_L_PXEDIS_Access "rw:config"
#define DSPIC33_CANFD_CON_L_PXEDIS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_PXEDIS_Pos) & DSPIC33_CANFD_CON_L_PXEDIS_Msk))
static inline uint16_t dspic33_canfd_con_l_pxedis_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_PXEDIS_Msk) >> DSPIC33_CANFD_CON_L_PXEDIS_Pos);
}
static inline uint16_t dspic33_canfd_con_l_pxedis_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_PXEDIS_Msk) | DSPIC33_CANFD_CON_L_PXEDIS_SET(value));
}
/* ISOCRCEN: CRC of CAN FD frames. Access rw:config. A write has an effect only if config (CONH.OPMOD ==
 * configuration).
 * Register 3-1; §2.1
 */
#define DSPIC33_CANFD_CON_L_ISOCRCEN_Pos 5U
#define DSPIC33_CANFD_CON_L_ISOCRCEN_Msk 0x0020U
#define DSPIC33_CANFD_CON_L_ISOCRCEN_Width 1U
#define DSPIC33_CANFD_CON_L_ISOCRCEN_Access "rw:config"
#define DSPIC33_CANFD_CON_L_ISOCRCEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_ISOCRCEN_Pos) & DSPIC33_CANFD_CON_L_ISOCRCEN_Msk))
static inline uint16_t dspic33_canfd_con_l_isocrcen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_ISOCRCEN_Msk) >> DSPIC33_CANFD_CON_L_ISOCRCEN_Pos);
}
static inline uint16_t dspic33_canfd_con_l_isocrcen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_ISOCRCEN_Msk) | DSPIC33_CANFD_CON_L_ISOCRCEN_SET(value));
}
/* DNCNT: DeviceNet filtering: number of data bits of a standard frame that are compared with EID0, EID1, ... of
 * a filter set up for standard frames, beginning with bit 7 of data byte 0. A shorter payload ends the
 * comparison early. Access rw. May be programmed with 0 to 18.
 * Contradictions of the manual: dncnt_invalid, data_filter_bits.
 * Register 3-1; §8.2.3; Table 8-1
 */
#define DSPIC33_CANFD_CON_L_DNCNT_Pos 0U
#define DSPIC33_CANFD_CON_L_DNCNT_Msk 0x001FU
#define DSPIC33_CANFD_CON_L_DNCNT_Width 5U
#define DSPIC33_CANFD_CON_L_DNCNT_Access "rw"
#define DSPIC33_CANFD_CON_L_DNCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_L_DNCNT_Pos) & DSPIC33_CANFD_CON_L_DNCNT_Msk))
static inline uint16_t dspic33_canfd_con_l_dncnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_L_DNCNT_Msk) >> DSPIC33_CANFD_CON_L_DNCNT_Pos);
}
static inline uint16_t dspic33_canfd_con_l_dncnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 18U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_L_DNCNT_Msk) | DSPIC33_CANFD_CON_L_DNCNT_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_con_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CONL;
    value = (uint16_t)((value & (uint16_t)~0x0800U) | 0x0000U);
    regs->CONL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* CONH: CAN Control Register High.
 * Operation mode, abort of all transmissions, and options that shape transmission and the memory layout.
 * Hazard: A mode request takes effect only when the bus is idle and the current message is complete. Wait for
 * OPMOD before relying on the new mode.
 * Hazard: Direct changes between the two Normal modes, or between Debug modes (listen only, restricted
 * operation, loopbacks), are not allowed; go through Configuration mode.
 * Hazard: After setting ABAT wait until TXREQL and TXREQH read 0, write ABAT 0 and check that it reads 0 before
 * queuing new messages; the manual contradicts itself about who clears it.
 * Contradictions of the manual: register_headings.
 * Register 3-2; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_CON_H_OFFSET 0x002U
#define DSPIC33_CANFD_CON_H_RESET 0x0498U
#define DSPIC33_CANFD_CON_H_RESET_MASK 0xFFFFU
/* TXBWS: Transmit bandwidth sharing: arbitration bit times the module stays idle after it has sent a message,
 * before it sends the next. There is no delay after a received message. Access rw.
 * Contradictions of the manual: txbws_values.
 * Register 3-2; §6.8
 */
#define DSPIC33_CANFD_CON_H_TXBWS_Pos 12U
#define DSPIC33_CANFD_CON_H_TXBWS_Msk 0xF000U
#define DSPIC33_CANFD_CON_H_TXBWS_Width 4U
#define DSPIC33_CANFD_CON_H_TXBWS_Access "rw"
#define DSPIC33_CANFD_CON_H_TXBWS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_TXBWS_Pos) & DSPIC33_CANFD_CON_H_TXBWS_Msk))
static inline uint16_t dspic33_canfd_con_h_txbws_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_TXBWS_Msk) >> DSPIC33_CANFD_CON_H_TXBWS_Pos);
}
static inline uint16_t dspic33_canfd_con_h_txbws_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_TXBWS_Msk) | DSPIC33_CANFD_CON_H_TXBWS_SET(value));
}
/* ABAT: Writing 1 aborts the pending transmissions of the queue and of all FIFOs. Hardware clears it when all
 * are aborted. A frame already on the bus is not stopped. Access w1s. A request: writing 1 makes it, writing 0
 * does nothing, hardware clears it.
 * Contradictions of the manual: abat_clear.
 * Register 3-2; §6.10
 */
#define DSPIC33_CANFD_CON_H_ABAT_Pos 11U
#define DSPIC33_CANFD_CON_H_ABAT_Msk 0x0800U
#define DSPIC33_CANFD_CON_H_ABAT_Width 1U
#define DSPIC33_CANFD_CON_H_ABAT_Access "w1s"
static inline uint16_t dspic33_canfd_con_h_abat_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_ABAT_Msk) >> DSPIC33_CANFD_CON_H_ABAT_Pos);
}
/* REQOP: Requested operation mode. The module goes there when the bus allows it. Access rw.
 * Register 3-2; §4.1
 */
#define DSPIC33_CANFD_CON_H_REQOP_Pos 8U
#define DSPIC33_CANFD_CON_H_REQOP_Msk 0x0700U
#define DSPIC33_CANFD_CON_H_REQOP_Width 3U
#define DSPIC33_CANFD_CON_H_REQOP_Access "rw"
#define DSPIC33_CANFD_CON_H_REQOP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_REQOP_Pos) & DSPIC33_CANFD_CON_H_REQOP_Msk))
static inline uint16_t dspic33_canfd_con_h_reqop_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_REQOP_Msk) >> DSPIC33_CANFD_CON_H_REQOP_Pos);
}
static inline uint16_t dspic33_canfd_con_h_reqop_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_REQOP_Msk) | DSPIC33_CANFD_CON_H_REQOP_SET(value));
}
/* OPMOD: Operation mode the module is in. Access ro. */
#define DSPIC33_CANFD_CON_H_OPMOD_Pos 5U
#define DSPIC33_CANFD_CON_H_OPMOD_Msk 0x00E0U
#define DSPIC33_CANFD_CON_H_OPMOD_Width 3U
#define DSPIC33_CANFD_CON_H_OPMOD_Access "ro"
static inline uint16_t dspic33_canfd_con_h_opmod_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_OPMOD_Msk) >> DSPIC33_CANFD_CON_H_OPMOD_Pos);
}
/* TXQEN: Enables the transmit queue and reserves RAM for it. Without it the queue cannot be used and takes no
 * RAM. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Register 3-2; §5.2.7
 */
#define DSPIC33_CANFD_CON_H_TXQEN_Pos 4U
#define DSPIC33_CANFD_CON_H_TXQEN_Msk 0x0010U
#define DSPIC33_CANFD_CON_H_TXQEN_Width 1U
#define DSPIC33_CANFD_CON_H_TXQEN_Access "rw:config"
#define DSPIC33_CANFD_CON_H_TXQEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_TXQEN_Pos) & DSPIC33_CANFD_CON_H_TXQEN_Msk))
static inline uint16_t dspic33_canfd_con_h_txqen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_TXQEN_Msk) >> DSPIC33_CANFD_CON_H_TXQEN_Pos);
}
static inline uint16_t dspic33_canfd_con_h_txqen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_TXQEN_Msk) | DSPIC33_CANFD_CON_H_TXQEN_SET(value));
}
/* STEF: Stores transmitted messages in the transmit event FIFO and reserves RAM for it. Access rw:config. A
 * write has an effect only if config (CONH.OPMOD == configuration).
 * Register 3-2; §5.2.7
 */
#define DSPIC33_CANFD_CON_H_STEF_Pos 3U
#define DSPIC33_CANFD_CON_H_STEF_Msk 0x0008U
#define DSPIC33_CANFD_CON_H_STEF_Width 1U
#define DSPIC33_CANFD_CON_H_STEF_Access "rw:config"
#define DSPIC33_CANFD_CON_H_STEF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_STEF_Pos) & DSPIC33_CANFD_CON_H_STEF_Msk))
static inline uint16_t dspic33_canfd_con_h_stef_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_STEF_Msk) >> DSPIC33_CANFD_CON_H_STEF_Pos);
}
static inline uint16_t dspic33_canfd_con_h_stef_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_STEF_Msk) | DSPIC33_CANFD_CON_H_STEF_SET(value));
}
/* SERRLOM: Mode the module falls into on a system error during transmission, such as inconsistent transmit data.
 * Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Register 3-2; §5.2.6; §12.3.6
 */
#define DSPIC33_CANFD_CON_H_SERRLOM_Pos 2U
#define DSPIC33_CANFD_CON_H_SERRLOM_Msk 0x0004U
#define DSPIC33_CANFD_CON_H_SERRLOM_Width 1U
#define DSPIC33_CANFD_CON_H_SERRLOM_Access "rw:config"
#define DSPIC33_CANFD_CON_H_SERRLOM_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_SERRLOM_Pos) & DSPIC33_CANFD_CON_H_SERRLOM_Msk))
static inline uint16_t dspic33_canfd_con_h_serrlom_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_SERRLOM_Msk) >> DSPIC33_CANFD_CON_H_SERRLOM_Pos);
}
static inline uint16_t dspic33_canfd_con_h_serrlom_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_SERRLOM_Msk) | DSPIC33_CANFD_CON_H_SERRLOM_SET(value));
}
/* ESIGM: ESI bit of transmitted CAN FD frames. Access rw:config. A write has an effect only if config
 * (CONH.OPMOD == configuration).
 * Register 3-2; §5.2.5
 */
#define DSPIC33_CANFD_CON_H_ESIGM_Pos 1U
#define DSPIC33_CANFD_CON_H_ESIGM_Msk 0x0002U
#define DSPIC33_CANFD_CON_H_ESIGM_Width 1U
#define DSPIC33_CANFD_CON_H_ESIGM_Access "rw:config"
#define DSPIC33_CANFD_CON_H_ESIGM_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_ESIGM_Pos) & DSPIC33_CANFD_CON_H_ESIGM_Msk))
static inline uint16_t dspic33_canfd_con_h_esigm_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_ESIGM_Msk) >> DSPIC33_CANFD_CON_H_ESIGM_Pos);
}
static inline uint16_t dspic33_canfd_con_h_esigm_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_ESIGM_Msk) | DSPIC33_CANFD_CON_H_ESIGM_SET(value));
}
/* RTXAT: Whether the retransmission attempts are limited. Access rw:config. A write has an effect only if config
 * (CONH.OPMOD == configuration).
 * Register 3-2; §5.2.4; §6.9
 */
#define DSPIC33_CANFD_CON_H_RTXAT_Pos 0U
#define DSPIC33_CANFD_CON_H_RTXAT_Msk 0x0001U
#define DSPIC33_CANFD_CON_H_RTXAT_Width 1U
#define DSPIC33_CANFD_CON_H_RTXAT_Access "rw:config"
#define DSPIC33_CANFD_CON_H_RTXAT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CON_H_RTXAT_Pos) & DSPIC33_CANFD_CON_H_RTXAT_Msk))
static inline uint16_t dspic33_canfd_con_h_rtxat_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CON_H_RTXAT_Msk) >> DSPIC33_CANFD_CON_H_RTXAT_Pos);
}
static inline uint16_t dspic33_canfd_con_h_rtxat_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CON_H_RTXAT_Msk) | DSPIC33_CANFD_CON_H_RTXAT_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_con_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->CONH;
    value = (uint16_t)((value & (uint16_t)~0x08E0U) | 0x0000U);
    regs->CONH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* NBTCFGL: CAN Nominal Bit Time Configuration Register Low.
 * Time segment 2 and synchronization jump width of the arbitration phase.
 * Contradictions of the manual: protected_fields.
 * Register 3-3; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_NBTCFG_L_OFFSET 0x004U
#define DSPIC33_CANFD_NBTCFG_L_RESET 0x0F0FU
#define DSPIC33_CANFD_NBTCFG_L_RESET_MASK 0xFFFFU
/* TSEG2: Time segment 2 (phase segment 2), 1 to 128 nominal time quanta. Access rw:config. A write has an effect
 * only if config (CONH.OPMOD == configuration). Means value + 1 tq.
 * Register 3-3; Table 5-1
 */
#define DSPIC33_CANFD_NBTCFG_L_TSEG2_Pos 8U
#define DSPIC33_CANFD_NBTCFG_L_TSEG2_Msk 0x7F00U
#define DSPIC33_CANFD_NBTCFG_L_TSEG2_Width 7U
#define DSPIC33_CANFD_NBTCFG_L_TSEG2_Access "rw:config"
#define DSPIC33_CANFD_NBTCFG_L_TSEG2_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_NBTCFG_L_TSEG2_Pos) & DSPIC33_CANFD_NBTCFG_L_TSEG2_Msk))
static inline uint16_t dspic33_canfd_nbtcfg_l_tseg2_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_NBTCFG_L_TSEG2_Msk) >> DSPIC33_CANFD_NBTCFG_L_TSEG2_Pos);
}
static inline uint16_t dspic33_canfd_nbtcfg_l_tseg2_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_NBTCFG_L_TSEG2_Msk) | DSPIC33_CANFD_NBTCFG_L_TSEG2_SET(value));
}
/* SJW: Synchronization jump width, 1 to 128 nominal time quanta; not more than either phase segment. Access
 * rw:config. A write has an effect only if config (CONH.OPMOD == configuration). Means value + 1 tq.
 * Register 3-3; Table 5-1; Table 5-3
 */
#define DSPIC33_CANFD_NBTCFG_L_SJW_Pos 0U
#define DSPIC33_CANFD_NBTCFG_L_SJW_Msk 0x007FU
#define DSPIC33_CANFD_NBTCFG_L_SJW_Width 7U
#define DSPIC33_CANFD_NBTCFG_L_SJW_Access "rw:config"
#define DSPIC33_CANFD_NBTCFG_L_SJW_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_NBTCFG_L_SJW_Pos) & DSPIC33_CANFD_NBTCFG_L_SJW_Msk))
static inline uint16_t dspic33_canfd_nbtcfg_l_sjw_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_NBTCFG_L_SJW_Msk) >> DSPIC33_CANFD_NBTCFG_L_SJW_Pos);
}
static inline uint16_t dspic33_canfd_nbtcfg_l_sjw_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_NBTCFG_L_SJW_Msk) | DSPIC33_CANFD_NBTCFG_L_SJW_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_nbtcfg_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->NBTCFGL;
    regs->NBTCFGL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* NBTCFGH: CAN Nominal Bit Time Configuration Register High.
 * Prescaler and time segment 1 of the arbitration phase.
 * Register 3-4; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_NBTCFG_H_OFFSET 0x006U
#define DSPIC33_CANFD_NBTCFG_H_RESET 0x003CU
#define DSPIC33_CANFD_NBTCFG_H_RESET_MASK 0xFFFFU
/* BRP: Prescaler: length of the nominal time quantum, 1 to 256 periods of the CAN clock. Access rw:config. A
 * write has an effect only if config (CONH.OPMOD == configuration). Means value + 1 FCAN periods.
 * Register 3-4; Equation 5-3
 */
#define DSPIC33_CANFD_NBTCFG_H_BRP_Pos 8U
#define DSPIC33_CANFD_NBTCFG_H_BRP_Msk 0xFF00U
#define DSPIC33_CANFD_NBTCFG_H_BRP_Width 8U
#define DSPIC33_CANFD_NBTCFG_H_BRP_Access "rw:config"
#define DSPIC33_CANFD_NBTCFG_H_BRP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_NBTCFG_H_BRP_Pos) & DSPIC33_CANFD_NBTCFG_H_BRP_Msk))
static inline uint16_t dspic33_canfd_nbtcfg_h_brp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_NBTCFG_H_BRP_Msk) >> DSPIC33_CANFD_NBTCFG_H_BRP_Pos);
}
static inline uint16_t dspic33_canfd_nbtcfg_h_brp_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_NBTCFG_H_BRP_Msk) | DSPIC33_CANFD_NBTCFG_H_BRP_SET(value));
}
/* TSEG1: Time segment 1 (propagation segment and phase segment 1), 2 to 256 nominal time quanta. Access
 * rw:config. A write has an effect only if config (CONH.OPMOD == configuration). May be programmed with 1 to
 * 255. Means value + 1 tq.
 * Contradictions of the manual: nbtcfgh_tseg1_reset, ntseg1_minimum.
 * Register 3-4; Table 5-1 (range)
 */
#define DSPIC33_CANFD_NBTCFG_H_TSEG1_Pos 0U
#define DSPIC33_CANFD_NBTCFG_H_TSEG1_Msk 0x00FFU
#define DSPIC33_CANFD_NBTCFG_H_TSEG1_Width 8U
#define DSPIC33_CANFD_NBTCFG_H_TSEG1_Access "rw:config"
#define DSPIC33_CANFD_NBTCFG_H_TSEG1_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_NBTCFG_H_TSEG1_Pos) & DSPIC33_CANFD_NBTCFG_H_TSEG1_Msk))
static inline uint16_t dspic33_canfd_nbtcfg_h_tseg1_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_NBTCFG_H_TSEG1_Msk) >> DSPIC33_CANFD_NBTCFG_H_TSEG1_Pos);
}
static inline uint16_t dspic33_canfd_nbtcfg_h_tseg1_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value >= 1U);
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_NBTCFG_H_TSEG1_Msk) | DSPIC33_CANFD_NBTCFG_H_TSEG1_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_nbtcfg_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->NBTCFGH;
    regs->NBTCFGH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* DBTCFGL: CAN Data Bit Time Configuration Register Low.
 * Time segment 2 and synchronization jump width of the data phase.
 * Contradictions of the manual: protected_fields.
 * Register 3-5; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_DBTCFG_L_OFFSET 0x008U
#define DSPIC33_CANFD_DBTCFG_L_RESET 0x0303U
#define DSPIC33_CANFD_DBTCFG_L_RESET_MASK 0xFFFFU
/* TSEG2: Time segment 2 (phase segment 2), 1 to 16 data time quanta. Access rw:config. A write has an effect
 * only if config (CONH.OPMOD == configuration). Means value + 1 tq.
 * Register 3-5; Table 5-2
 */
#define DSPIC33_CANFD_DBTCFG_L_TSEG2_Pos 8U
#define DSPIC33_CANFD_DBTCFG_L_TSEG2_Msk 0x0F00U
#define DSPIC33_CANFD_DBTCFG_L_TSEG2_Width 4U
#define DSPIC33_CANFD_DBTCFG_L_TSEG2_Access "rw:config"
#define DSPIC33_CANFD_DBTCFG_L_TSEG2_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_DBTCFG_L_TSEG2_Pos) & DSPIC33_CANFD_DBTCFG_L_TSEG2_Msk))
static inline uint16_t dspic33_canfd_dbtcfg_l_tseg2_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_DBTCFG_L_TSEG2_Msk) >> DSPIC33_CANFD_DBTCFG_L_TSEG2_Pos);
}
static inline uint16_t dspic33_canfd_dbtcfg_l_tseg2_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_DBTCFG_L_TSEG2_Msk) | DSPIC33_CANFD_DBTCFG_L_TSEG2_SET(value));
}
/* SJW: Synchronization jump width, 1 to 16 data time quanta; not more than either phase segment. Access
 * rw:config. A write has an effect only if config (CONH.OPMOD == configuration). Means value + 1 tq.
 * Register 3-5; Table 5-2; Table 5-4
 */
#define DSPIC33_CANFD_DBTCFG_L_SJW_Pos 0U
#define DSPIC33_CANFD_DBTCFG_L_SJW_Msk 0x000FU
#define DSPIC33_CANFD_DBTCFG_L_SJW_Width 4U
#define DSPIC33_CANFD_DBTCFG_L_SJW_Access "rw:config"
#define DSPIC33_CANFD_DBTCFG_L_SJW_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_DBTCFG_L_SJW_Pos) & DSPIC33_CANFD_DBTCFG_L_SJW_Msk))
static inline uint16_t dspic33_canfd_dbtcfg_l_sjw_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_DBTCFG_L_SJW_Msk) >> DSPIC33_CANFD_DBTCFG_L_SJW_Pos);
}
static inline uint16_t dspic33_canfd_dbtcfg_l_sjw_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_DBTCFG_L_SJW_Msk) | DSPIC33_CANFD_DBTCFG_L_SJW_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_dbtcfg_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->DBTCFGL;
    regs->DBTCFGL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* DBTCFGH: CAN Data Bit Time Configuration Register High.
 * Prescaler and time segment 1 of the data phase.
 * Contradictions of the manual: register_headings.
 * Register 3-6; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_DBTCFG_H_OFFSET 0x00AU
#define DSPIC33_CANFD_DBTCFG_H_RESET 0x000EU
#define DSPIC33_CANFD_DBTCFG_H_RESET_MASK 0xFFFFU
/* BRP: Prescaler: length of the data time quantum, 1 to 256 periods of the CAN clock. Equal to the nominal
 * prescaler it avoids a quantization error at the rate switch. Access rw:config. A write has an effect only if
 * config (CONH.OPMOD == configuration). Means value + 1 FCAN periods.
 * Register 3-6; Equation 5-4; §5.3.7
 */
#define DSPIC33_CANFD_DBTCFG_H_BRP_Pos 8U
#define DSPIC33_CANFD_DBTCFG_H_BRP_Msk 0xFF00U
#define DSPIC33_CANFD_DBTCFG_H_BRP_Width 8U
#define DSPIC33_CANFD_DBTCFG_H_BRP_Access "rw:config"
#define DSPIC33_CANFD_DBTCFG_H_BRP_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_DBTCFG_H_BRP_Pos) & DSPIC33_CANFD_DBTCFG_H_BRP_Msk))
static inline uint16_t dspic33_canfd_dbtcfg_h_brp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_DBTCFG_H_BRP_Msk) >> DSPIC33_CANFD_DBTCFG_H_BRP_Pos);
}
static inline uint16_t dspic33_canfd_dbtcfg_h_brp_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_DBTCFG_H_BRP_Msk) | DSPIC33_CANFD_DBTCFG_H_BRP_SET(value));
}
/* TSEG1: Time segment 1 (propagation segment and phase segment 1), 1 to 32 data time quanta. Access rw:config. A
 * write has an effect only if config (CONH.OPMOD == configuration). Means value + 1 tq.
 * Register 3-6; Table 5-2
 */
#define DSPIC33_CANFD_DBTCFG_H_TSEG1_Pos 0U
#define DSPIC33_CANFD_DBTCFG_H_TSEG1_Msk 0x001FU
#define DSPIC33_CANFD_DBTCFG_H_TSEG1_Width 5U
#define DSPIC33_CANFD_DBTCFG_H_TSEG1_Access "rw:config"
#define DSPIC33_CANFD_DBTCFG_H_TSEG1_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_DBTCFG_H_TSEG1_Pos) & DSPIC33_CANFD_DBTCFG_H_TSEG1_Msk))
static inline uint16_t dspic33_canfd_dbtcfg_h_tseg1_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_DBTCFG_H_TSEG1_Msk) >> DSPIC33_CANFD_DBTCFG_H_TSEG1_Pos);
}
static inline uint16_t dspic33_canfd_dbtcfg_h_tseg1_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_DBTCFG_H_TSEG1_Msk) | DSPIC33_CANFD_DBTCFG_H_TSEG1_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_dbtcfg_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->DBTCFGH;
    regs->DBTCFGH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TDCL: CAN Transmitter Delay Compensation Register Low.
 * Offset and value that place the secondary sample point of the data phase.
 * Register 3-7; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TDC_L_OFFSET 0x00CU
#define DSPIC33_CANFD_TDC_L_RESET 0x1000U
#define DSPIC33_CANFD_TDC_L_RESET_MASK 0xFFFFU
/* TDCO: Offset added to the transceiver delay to give the secondary sample point, -64 to 63 periods of the CAN
 * clock in two's complement. The prescaler times time segment 1 of the data phase puts it at the data sample
 * point. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration). Means value as
 * two's complement FCAN periods.
 * Contradictions of the manual: tdco_sign.
 * Register 3-7; §5.3.8
 */
#define DSPIC33_CANFD_TDC_L_TDCO_Pos 8U
#define DSPIC33_CANFD_TDC_L_TDCO_Msk 0x7F00U
#define DSPIC33_CANFD_TDC_L_TDCO_Width 7U
#define DSPIC33_CANFD_TDC_L_TDCO_Access "rw:config"
#define DSPIC33_CANFD_TDC_L_TDCO_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TDC_L_TDCO_Pos) & DSPIC33_CANFD_TDC_L_TDCO_Msk))
static inline uint16_t dspic33_canfd_tdc_l_tdco_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TDC_L_TDCO_Msk) >> DSPIC33_CANFD_TDC_L_TDCO_Pos);
}
static inline uint16_t dspic33_canfd_tdc_l_tdco_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TDC_L_TDCO_Msk) | DSPIC33_CANFD_TDC_L_TDCO_SET(value));
}
/* TDCV: Transceiver delay used in manual mode, 0 to 63 periods of the CAN clock. Access rw:config. A write has
 * an effect only if config (CONH.OPMOD == configuration). Means value FCAN periods.
 */
#define DSPIC33_CANFD_TDC_L_TDCV_Pos 0U
#define DSPIC33_CANFD_TDC_L_TDCV_Msk 0x003FU
#define DSPIC33_CANFD_TDC_L_TDCV_Width 6U
#define DSPIC33_CANFD_TDC_L_TDCV_Access "rw:config"
#define DSPIC33_CANFD_TDC_L_TDCV_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TDC_L_TDCV_Pos) & DSPIC33_CANFD_TDC_L_TDCV_Msk))
static inline uint16_t dspic33_canfd_tdc_l_tdcv_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TDC_L_TDCV_Msk) >> DSPIC33_CANFD_TDC_L_TDCV_Pos);
}
static inline uint16_t dspic33_canfd_tdc_l_tdcv_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 63U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TDC_L_TDCV_Msk) | DSPIC33_CANFD_TDC_L_TDCV_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tdc_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TDCL;
    regs->TDCL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TDCH: CAN Transmitter Delay Compensation Register High.
 * Mode of the transmitter delay compensation, edge filtering and 12-bit standard IDs.
 * Contradictions of the manual: protected_fields.
 * Register 3-8; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TDC_H_OFFSET 0x00EU
#define DSPIC33_CANFD_TDC_H_RESET 0x0002U
#define DSPIC33_CANFD_TDC_H_RESET_MASK 0xFFFFU
/* EDGFLTEN: Enables the edge filtering of ISO 11898-1:2015 while the module integrates to the bus. Access
 * rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 */
#define DSPIC33_CANFD_TDC_H_EDGFLTEN_Pos 9U
#define DSPIC33_CANFD_TDC_H_EDGFLTEN_Msk 0x0200U
#define DSPIC33_CANFD_TDC_H_EDGFLTEN_Width 1U
#define DSPIC33_CANFD_TDC_H_EDGFLTEN_Access "rw:config"
#define DSPIC33_CANFD_TDC_H_EDGFLTEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TDC_H_EDGFLTEN_Pos) & DSPIC33_CANFD_TDC_H_EDGFLTEN_Msk))
static inline uint16_t dspic33_canfd_tdc_h_edgflten_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TDC_H_EDGFLTEN_Msk) >> DSPIC33_CANFD_TDC_H_EDGFLTEN_Pos);
}
static inline uint16_t dspic33_canfd_tdc_h_edgflten_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TDC_H_EDGFLTEN_Msk) | DSPIC33_CANFD_TDC_H_EDGFLTEN_SET(value));
}
/* SID11EN: Uses the RRS bit of CAN FD base frames as SID11, the least significant bit of a 12-bit standard ID.
 * Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Contradictions of the manual: sid11_bit.
 * Register 3-8; §8.2.4
 */
#define DSPIC33_CANFD_TDC_H_SID11EN_Pos 8U
#define DSPIC33_CANFD_TDC_H_SID11EN_Msk 0x0100U
#define DSPIC33_CANFD_TDC_H_SID11EN_Width 1U
#define DSPIC33_CANFD_TDC_H_SID11EN_Access "rw:config"
#define DSPIC33_CANFD_TDC_H_SID11EN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TDC_H_SID11EN_Pos) & DSPIC33_CANFD_TDC_H_SID11EN_Msk))
static inline uint16_t dspic33_canfd_tdc_h_sid11en_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TDC_H_SID11EN_Msk) >> DSPIC33_CANFD_TDC_H_SID11EN_Pos);
}
static inline uint16_t dspic33_canfd_tdc_h_sid11en_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TDC_H_SID11EN_Msk) | DSPIC33_CANFD_TDC_H_SID11EN_SET(value));
}
/* TDCMOD: Mode of the transmitter delay compensation. Automatic measurement is recommended from 1 Mbit/s data
 * rate. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Register 3-8; §5.3.7
 */
#define DSPIC33_CANFD_TDC_H_TDCMOD_Pos 0U
#define DSPIC33_CANFD_TDC_H_TDCMOD_Msk 0x0003U
#define DSPIC33_CANFD_TDC_H_TDCMOD_Width 2U
#define DSPIC33_CANFD_TDC_H_TDCMOD_Access "rw:config"
#define DSPIC33_CANFD_TDC_H_TDCMOD_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TDC_H_TDCMOD_Pos) & DSPIC33_CANFD_TDC_H_TDCMOD_Msk))
static inline uint16_t dspic33_canfd_tdc_h_tdcmod_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TDC_H_TDCMOD_Msk) >> DSPIC33_CANFD_TDC_H_TDCMOD_Pos);
}
static inline uint16_t dspic33_canfd_tdc_h_tdcmod_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TDC_H_TDCMOD_Msk) | DSPIC33_CANFD_TDC_H_TDCMOD_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tdc_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TDCH;
    regs->TDCH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TBCL: CAN Time Base Counter Register Low.
 * Bits 15 to 0 of the free-running counter that timestamps messages.
 * Hazard: The counter runs on between the reads of its two halves; read the high half again and repeat if it
 * changed.
 * Hazard: Any write to either half resets the prescaler's count, though not the prescaler setting.
 * Hazard: Disabling the counter stops and resets it.
 * Contradictions of the manual: tbc_write_while_stopped.
 * Register 3-9; §11.0 p.108; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TBC_L_OFFSET 0x010U
#define DSPIC33_CANFD_TBC_L_RESET 0x0000U
#define DSPIC33_CANFD_TBC_L_RESET_MASK 0xFFFFU
/* TBC[15:0]: Low half of the counter, in steps of TBCPRE + 1 clock periods. Access rwh:tbc_stopped. Read and
 * write, but hardware changes it too: writing back a stale value undoes the hardware. A write has an effect only
 * if tbc_stopped (!TSCONH.TBCEN).
 */
#define DSPIC33_CANFD_TBC_L_TBC_Pos 0U
#define DSPIC33_CANFD_TBC_L_TBC_Msk 0xFFFFU
#define DSPIC33_CANFD_TBC_L_TBC_Width 16U
#define DSPIC33_CANFD_TBC_L_TBC_Access "rwh:tbc_stopped"
#define DSPIC33_CANFD_TBC_L_TBC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TBC_L_TBC_Pos) & DSPIC33_CANFD_TBC_L_TBC_Msk))
static inline uint16_t dspic33_canfd_tbc_l_tbc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TBC_L_TBC_Msk) >> DSPIC33_CANFD_TBC_L_TBC_Pos);
}
static inline uint16_t dspic33_canfd_tbc_l_tbc_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TBC_L_TBC_Msk) | DSPIC33_CANFD_TBC_L_TBC_SET(value));
}
/* No read-modify-write: no value written to TBC leaves it alone. Compose the whole value and store it. */

/* TBCH: CAN Time Base Counter Register High.
 * Bits 31 to 16 of the free-running counter that timestamps messages.
 * Hazard: Any write to either half resets the prescaler's count, though not the prescaler setting.
 * Contradictions of the manual: tbc_write_while_stopped.
 * Register 3-10; §11.0 p.108; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TBC_H_OFFSET 0x012U
#define DSPIC33_CANFD_TBC_H_RESET 0x0000U
#define DSPIC33_CANFD_TBC_H_RESET_MASK 0xFFFFU
/* TBC[31:16]: High half of the counter. Its rollover to 0 sets TBCIF. Access rwh:tbc_stopped. Read and write,
 * but hardware changes it too: writing back a stale value undoes the hardware. A write has an effect only if
 * tbc_stopped (!TSCONH.TBCEN).
 */
#define DSPIC33_CANFD_TBC_H_TBC_Pos 0U
#define DSPIC33_CANFD_TBC_H_TBC_Msk 0xFFFFU
#define DSPIC33_CANFD_TBC_H_TBC_Width 16U
#define DSPIC33_CANFD_TBC_H_TBC_Access "rwh:tbc_stopped"
#define DSPIC33_CANFD_TBC_H_TBC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TBC_H_TBC_Pos) & DSPIC33_CANFD_TBC_H_TBC_Msk))
static inline uint16_t dspic33_canfd_tbc_h_tbc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TBC_H_TBC_Msk) >> DSPIC33_CANFD_TBC_H_TBC_Pos);
}
static inline uint16_t dspic33_canfd_tbc_h_tbc_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TBC_H_TBC_Msk) | DSPIC33_CANFD_TBC_H_TBC_SET(value));
}
/* No read-modify-write: no value written to TBC leaves it alone. Compose the whole value and store it. */

/* TSCONL: CAN Timestamp Control Register Low.
 * Prescaler of the Time Base Counter.
 * Register 3-11; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TSCON_L_OFFSET 0x014U
#define DSPIC33_CANFD_TSCON_L_RESET 0x0000U
#define DSPIC33_CANFD_TSCON_L_RESET_MASK 0xFFFFU
/* TBCPRE: The counter increments every TBCPRE + 1 periods of the CAN clock. Access rw. Means value + 1 FCAN
 * periods.
 * Contradictions of the manual: tbc_prescaler.
 */
#define DSPIC33_CANFD_TSCON_L_TBCPRE_Pos 0U
#define DSPIC33_CANFD_TSCON_L_TBCPRE_Msk 0x03FFU
#define DSPIC33_CANFD_TSCON_L_TBCPRE_Width 10U
#define DSPIC33_CANFD_TSCON_L_TBCPRE_Access "rw"
#define DSPIC33_CANFD_TSCON_L_TBCPRE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TSCON_L_TBCPRE_Pos) & DSPIC33_CANFD_TSCON_L_TBCPRE_Msk))
static inline uint16_t dspic33_canfd_tscon_l_tbcpre_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TSCON_L_TBCPRE_Msk) >> DSPIC33_CANFD_TSCON_L_TBCPRE_Pos);
}
static inline uint16_t dspic33_canfd_tscon_l_tbcpre_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1023U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TSCON_L_TBCPRE_Msk) | DSPIC33_CANFD_TSCON_L_TBCPRE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tscon_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TSCONL;
    regs->TSCONL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TSCONH: CAN Timestamp Control Register High.
 * Reference point of timestamps and enable of the Time Base Counter.
 * Hazard: Timestamping in a receive FIFO or in the event FIFO does not start the counter; without TBCEN no time
 * passes and timestamps stay 0.
 * Register 3-12; §11.0 p.108; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TSCON_H_OFFSET 0x016U
#define DSPIC33_CANFD_TSCON_H_RESET 0x0000U
#define DSPIC33_CANFD_TSCON_H_RESET_MASK 0xFFFFU
/* TSRES: Reference point of CAN FD frames that are timestamped at their beginning (TSEOF = 0). Access rw. */
#define DSPIC33_CANFD_TSCON_H_TSRES_Pos 2U
#define DSPIC33_CANFD_TSCON_H_TSRES_Msk 0x0004U
#define DSPIC33_CANFD_TSCON_H_TSRES_Width 1U
#define DSPIC33_CANFD_TSCON_H_TSRES_Access "rw"
#define DSPIC33_CANFD_TSCON_H_TSRES_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TSCON_H_TSRES_Pos) & DSPIC33_CANFD_TSCON_H_TSRES_Msk))
static inline uint16_t dspic33_canfd_tscon_h_tsres_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TSCON_H_TSRES_Msk) >> DSPIC33_CANFD_TSCON_H_TSRES_Pos);
}
static inline uint16_t dspic33_canfd_tscon_h_tsres_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TSCON_H_TSRES_Msk) | DSPIC33_CANFD_TSCON_H_TSRES_SET(value));
}
/* TSEOF: Whether frames are timestamped at their beginning or when they become valid. Access rw.
 * Register 3-12; Table 11-1
 */
#define DSPIC33_CANFD_TSCON_H_TSEOF_Pos 1U
#define DSPIC33_CANFD_TSCON_H_TSEOF_Msk 0x0002U
#define DSPIC33_CANFD_TSCON_H_TSEOF_Width 1U
#define DSPIC33_CANFD_TSCON_H_TSEOF_Access "rw"
#define DSPIC33_CANFD_TSCON_H_TSEOF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TSCON_H_TSEOF_Pos) & DSPIC33_CANFD_TSCON_H_TSEOF_Msk))
static inline uint16_t dspic33_canfd_tscon_h_tseof_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TSCON_H_TSEOF_Msk) >> DSPIC33_CANFD_TSCON_H_TSEOF_Pos);
}
static inline uint16_t dspic33_canfd_tscon_h_tseof_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TSCON_H_TSEOF_Msk) | DSPIC33_CANFD_TSCON_H_TSEOF_SET(value));
}
/* TBCEN: Enables the counter. Clearing it stops and resets the counter. Access rw.
 * Contradictions of the manual: tbc_write_while_stopped.
 */
#define DSPIC33_CANFD_TSCON_H_TBCEN_Pos 0U
#define DSPIC33_CANFD_TSCON_H_TBCEN_Msk 0x0001U
#define DSPIC33_CANFD_TSCON_H_TBCEN_Width 1U
#define DSPIC33_CANFD_TSCON_H_TBCEN_Access "rw"
#define DSPIC33_CANFD_TSCON_H_TBCEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TSCON_H_TBCEN_Pos) & DSPIC33_CANFD_TSCON_H_TBCEN_Msk))
static inline uint16_t dspic33_canfd_tscon_h_tbcen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TSCON_H_TBCEN_Msk) >> DSPIC33_CANFD_TSCON_H_TBCEN_Pos);
}
static inline uint16_t dspic33_canfd_tscon_h_tbcen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TSCON_H_TBCEN_Msk) | DSPIC33_CANFD_TSCON_H_TBCEN_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tscon_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TSCONH;
    regs->TSCONH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* VECL: CAN Interrupt Code Register Low.
 * Highest-numbered pending interrupt and the filter that matched, for a jump table. Combinational from the
 * flags.
 * Contradictions of the manual: status_single_read.
 * Register 3-13; §12.4.1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_VEC_L_OFFSET 0x018U
#define DSPIC33_CANFD_VEC_L_RESET 0x0040U
#define DSPIC33_CANFD_VEC_L_RESET_MASK 0xFFFFU
/* FILHIT: Number of the filter that matched. Access ro. */
#define DSPIC33_CANFD_VEC_L_FILHIT_Pos 8U
#define DSPIC33_CANFD_VEC_L_FILHIT_Msk 0x1F00U
#define DSPIC33_CANFD_VEC_L_FILHIT_Width 5U
#define DSPIC33_CANFD_VEC_L_FILHIT_Access "ro"
static inline uint16_t dspic33_canfd_vec_l_filhit_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_VEC_L_FILHIT_Msk) >> DSPIC33_CANFD_VEC_L_FILHIT_Pos);
}
/* ICODE: Code of the pending interrupt. Of several the one with the highest number shows. Access ro. */
#define DSPIC33_CANFD_VEC_L_ICODE_Pos 0U
#define DSPIC33_CANFD_VEC_L_ICODE_Msk 0x007FU
#define DSPIC33_CANFD_VEC_L_ICODE_Width 7U
#define DSPIC33_CANFD_VEC_L_ICODE_Access "ro"
static inline uint16_t dspic33_canfd_vec_l_icode_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_VEC_L_ICODE_Msk) >> DSPIC33_CANFD_VEC_L_ICODE_Pos);
}

/* VECH: CAN Interrupt Code Register High.
 * Highest-numbered FIFO with a receive interrupt and with a transmit interrupt, for separate jump tables.
 * Contradictions of the manual: status_single_read.
 * Register 3-14; §12.4.1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_VEC_H_OFFSET 0x01AU
#define DSPIC33_CANFD_VEC_H_RESET 0x4040U
#define DSPIC33_CANFD_VEC_H_RESET_MASK 0xFFFFU
/* RXCODE: Which FIFO has a receive interrupt pending; the highest number shows. Access ro. */
#define DSPIC33_CANFD_VEC_H_RXCODE_Pos 8U
#define DSPIC33_CANFD_VEC_H_RXCODE_Msk 0x7F00U
#define DSPIC33_CANFD_VEC_H_RXCODE_Width 7U
#define DSPIC33_CANFD_VEC_H_RXCODE_Access "ro"
static inline uint16_t dspic33_canfd_vec_h_rxcode_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_VEC_H_RXCODE_Msk) >> DSPIC33_CANFD_VEC_H_RXCODE_Pos);
}
/* TXCODE: Which FIFO or queue has a transmit interrupt pending; the highest number shows. Access ro. */
#define DSPIC33_CANFD_VEC_H_TXCODE_Pos 0U
#define DSPIC33_CANFD_VEC_H_TXCODE_Msk 0x007FU
#define DSPIC33_CANFD_VEC_H_TXCODE_Width 7U
#define DSPIC33_CANFD_VEC_H_TXCODE_Access "ro"
static inline uint16_t dspic33_canfd_vec_h_txcode_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_VEC_H_TXCODE_Msk) >> DSPIC33_CANFD_VEC_H_TXCODE_Pos);
}

/* INTL: CAN Interrupt Register Low.
 * Main interrupt flags. Some are cleared here by writing 0; the others mirror conditions that have to be cleared
 * where they arise.
 * Hazard: Clear a flag with a word that has 0 in its place and 1 in all others; a read-modify-write loses flags
 * that rise in between.
 * Hazard: RXOVIF, TXATIF, TEFIF, RXIF and TXIF are read-only; clear them in the FIFO, queue or event FIFO.
 * Contradictions of the manual: status_single_read.
 * Register 3-15; §12.3; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_INT_L_OFFSET 0x01CU
#define DSPIC33_CANFD_INT_L_RESET 0x0000U
#define DSPIC33_CANFD_INT_L_RESET_MASK 0xFFFFU
/* IVMIF: A CAN bus error or a DLC mismatch in the last message sent or received; BDIAG1H tells which. A received
 * ESI does not set it. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Register 3-15; §12.3.1
 */
#define DSPIC33_CANFD_INT_L_IVMIF_Pos 15U
#define DSPIC33_CANFD_INT_L_IVMIF_Msk 0x8000U
#define DSPIC33_CANFD_INT_L_IVMIF_Width 1U
#define DSPIC33_CANFD_INT_L_IVMIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_ivmif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_IVMIF_Msk) >> DSPIC33_CANFD_INT_L_IVMIF_Pos);
}
/* WAKIF: Bus activity was detected while the module was in Sleep mode. The message that did it is lost;
 * reception starts again after 11 recessive bits in a requested Normal mode. Access w0c. A flag: writing 0
 * clears it, writing 1 does nothing.
 * Contradictions of the manual: wake_up_in_disable_mode.
 * Register 3-15; §12.3.2; §4.6.3
 */
#define DSPIC33_CANFD_INT_L_WAKIF_Pos 14U
#define DSPIC33_CANFD_INT_L_WAKIF_Msk 0x4000U
#define DSPIC33_CANFD_INT_L_WAKIF_Width 1U
#define DSPIC33_CANFD_INT_L_WAKIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_wakif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_WAKIF_Msk) >> DSPIC33_CANFD_INT_L_WAKIF_Pos);
}
/* CERRIF: An error counter crossed a threshold: warning, error passive, bus off or the way back. Once cleared it
 * stays clear until the next crossing. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Register 3-15; §12.3.3
 */
#define DSPIC33_CANFD_INT_L_CERRIF_Pos 13U
#define DSPIC33_CANFD_INT_L_CERRIF_Msk 0x2000U
#define DSPIC33_CANFD_INT_L_CERRIF_Width 1U
#define DSPIC33_CANFD_INT_L_CERRIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_cerrif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_CERRIF_Msk) >> DSPIC33_CANFD_INT_L_CERRIF_Pos);
}
/* SERRIF: System error: receive message assembly buffer overflow, transmit message assembly buffer underflow, or
 * an illegal address. Clearing it also takes it out of ICODE. Access w0c. A flag: writing 0 clears it, writing 1
 * does nothing.
 * Register 3-15; §12.3.6
 */
#define DSPIC33_CANFD_INT_L_SERRIF_Pos 12U
#define DSPIC33_CANFD_INT_L_SERRIF_Msk 0x1000U
#define DSPIC33_CANFD_INT_L_SERRIF_Width 1U
#define DSPIC33_CANFD_INT_L_SERRIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_serrif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_SERRIF_Msk) >> DSPIC33_CANFD_INT_L_SERRIF_Pos);
}
/* RXOVIF: At least one FIFO has a receive overflow (OR of RXOVIFL/H). Access ro. */
#define DSPIC33_CANFD_INT_L_RXOVIF_Pos 11U
#define DSPIC33_CANFD_INT_L_RXOVIF_Msk 0x0800U
#define DSPIC33_CANFD_INT_L_RXOVIF_Width 1U
#define DSPIC33_CANFD_INT_L_RXOVIF_Access "ro"
static inline uint16_t dspic33_canfd_int_l_rxovif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_RXOVIF_Msk) >> DSPIC33_CANFD_INT_L_RXOVIF_Pos);
}
/* TXATIF: The queue or at least one FIFO has exhausted its transmit attempts (OR of TXATIFL/H). Access ro. */
#define DSPIC33_CANFD_INT_L_TXATIF_Pos 10U
#define DSPIC33_CANFD_INT_L_TXATIF_Msk 0x0400U
#define DSPIC33_CANFD_INT_L_TXATIF_Width 1U
#define DSPIC33_CANFD_INT_L_TXATIF_Access "ro"
static inline uint16_t dspic33_canfd_int_l_txatif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_TXATIF_Msk) >> DSPIC33_CANFD_INT_L_TXATIF_Pos);
}
/* TEFIF: The transmit event FIFO has an enabled interrupt pending. Access ro.
 * Register 3-15; §12.1.6
 */
#define DSPIC33_CANFD_INT_L_TEFIF_Pos 4U
#define DSPIC33_CANFD_INT_L_TEFIF_Msk 0x0010U
#define DSPIC33_CANFD_INT_L_TEFIF_Width 1U
#define DSPIC33_CANFD_INT_L_TEFIF_Access "ro"
static inline uint16_t dspic33_canfd_int_l_tefif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_TEFIF_Msk) >> DSPIC33_CANFD_INT_L_TEFIF_Pos);
}
/* MODIF: OPMOD has changed. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: modif_cause.
 * Register 3-15; §12.3.4
 */
#define DSPIC33_CANFD_INT_L_MODIF_Pos 3U
#define DSPIC33_CANFD_INT_L_MODIF_Msk 0x0008U
#define DSPIC33_CANFD_INT_L_MODIF_Width 1U
#define DSPIC33_CANFD_INT_L_MODIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_modif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_MODIF_Msk) >> DSPIC33_CANFD_INT_L_MODIF_Pos);
}
/* TBCIF: The Time Base Counter rolled over. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Register 3-15; §12.3.5
 */
#define DSPIC33_CANFD_INT_L_TBCIF_Pos 2U
#define DSPIC33_CANFD_INT_L_TBCIF_Msk 0x0004U
#define DSPIC33_CANFD_INT_L_TBCIF_Width 1U
#define DSPIC33_CANFD_INT_L_TBCIF_Access "w0c"
static inline uint16_t dspic33_canfd_int_l_tbcif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_TBCIF_Msk) >> DSPIC33_CANFD_INT_L_TBCIF_Pos);
}
/* RXIF: At least one FIFO has an enabled receive interrupt pending (OR of RXIFL/H). Access ro. */
#define DSPIC33_CANFD_INT_L_RXIF_Pos 1U
#define DSPIC33_CANFD_INT_L_RXIF_Msk 0x0002U
#define DSPIC33_CANFD_INT_L_RXIF_Width 1U
#define DSPIC33_CANFD_INT_L_RXIF_Access "ro"
static inline uint16_t dspic33_canfd_int_l_rxif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_RXIF_Msk) >> DSPIC33_CANFD_INT_L_RXIF_Pos);
}
/* TXIF: The queue or at least one FIFO has an enabled transmit interrupt pending (OR of TXIFL/H). Access ro. */
#define DSPIC33_CANFD_INT_L_TXIF_Pos 0U
#define DSPIC33_CANFD_INT_L_TXIF_Msk 0x0001U
#define DSPIC33_CANFD_INT_L_TXIF_Width 1U
#define DSPIC33_CANFD_INT_L_TXIF_Access "ro"
static inline uint16_t dspic33_canfd_int_l_txif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_L_TXIF_Msk) >> DSPIC33_CANFD_INT_L_TXIF_Pos);
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_canfd_int_l_clear(dspic33_canfd_regs_t *regs, uint16_t flags)
{
    regs->INTL = (uint16_t)(0xF00CU & (uint16_t)~flags);
}

/* INTH: CAN Interrupt Register High.
 * Enables of the main interrupts.
 * Contradictions of the manual: status_single_read.
 * Register 3-16; §12.3; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_INT_H_OFFSET 0x01EU
#define DSPIC33_CANFD_INT_H_RESET 0x0000U
#define DSPIC33_CANFD_INT_H_RESET_MASK 0xFFFFU
/* IVMIE: Enables the invalid message interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_IVMIE_Pos 15U
#define DSPIC33_CANFD_INT_H_IVMIE_Msk 0x8000U
#define DSPIC33_CANFD_INT_H_IVMIE_Width 1U
#define DSPIC33_CANFD_INT_H_IVMIE_Access "rw"
#define DSPIC33_CANFD_INT_H_IVMIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_IVMIE_Pos) & DSPIC33_CANFD_INT_H_IVMIE_Msk))
static inline uint16_t dspic33_canfd_int_h_ivmie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_IVMIE_Msk) >> DSPIC33_CANFD_INT_H_IVMIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_ivmie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_IVMIE_Msk) | DSPIC33_CANFD_INT_H_IVMIE_SET(value));
}
/* WAKIE: Enables the wake-up interrupt; needed for a dominant edge on CxRX to wake the device. Access rw.
 * Contradictions of the manual: wake_up_in_disable_mode.
 */
#define DSPIC33_CANFD_INT_H_WAKIE_Pos 14U
#define DSPIC33_CANFD_INT_H_WAKIE_Msk 0x4000U
#define DSPIC33_CANFD_INT_H_WAKIE_Width 1U
#define DSPIC33_CANFD_INT_H_WAKIE_Access "rw"
#define DSPIC33_CANFD_INT_H_WAKIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_WAKIE_Pos) & DSPIC33_CANFD_INT_H_WAKIE_Msk))
static inline uint16_t dspic33_canfd_int_h_wakie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_WAKIE_Msk) >> DSPIC33_CANFD_INT_H_WAKIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_wakie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_WAKIE_Msk) | DSPIC33_CANFD_INT_H_WAKIE_SET(value));
}
/* CERRIE: Enables the CAN bus error interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_CERRIE_Pos 13U
#define DSPIC33_CANFD_INT_H_CERRIE_Msk 0x2000U
#define DSPIC33_CANFD_INT_H_CERRIE_Width 1U
#define DSPIC33_CANFD_INT_H_CERRIE_Access "rw"
#define DSPIC33_CANFD_INT_H_CERRIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_CERRIE_Pos) & DSPIC33_CANFD_INT_H_CERRIE_Msk))
static inline uint16_t dspic33_canfd_int_h_cerrie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_CERRIE_Msk) >> DSPIC33_CANFD_INT_H_CERRIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_cerrie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_CERRIE_Msk) | DSPIC33_CANFD_INT_H_CERRIE_SET(value));
}
/* SERRIE: Enables the system error interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_SERRIE_Pos 12U
#define DSPIC33_CANFD_INT_H_SERRIE_Msk 0x1000U
#define DSPIC33_CANFD_INT_H_SERRIE_Width 1U
#define DSPIC33_CANFD_INT_H_SERRIE_Access "rw"
#define DSPIC33_CANFD_INT_H_SERRIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_SERRIE_Pos) & DSPIC33_CANFD_INT_H_SERRIE_Msk))
static inline uint16_t dspic33_canfd_int_h_serrie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_SERRIE_Msk) >> DSPIC33_CANFD_INT_H_SERRIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_serrie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_SERRIE_Msk) | DSPIC33_CANFD_INT_H_SERRIE_SET(value));
}
/* RXOVIE: Enables the receive overflow interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_RXOVIE_Pos 11U
#define DSPIC33_CANFD_INT_H_RXOVIE_Msk 0x0800U
#define DSPIC33_CANFD_INT_H_RXOVIE_Width 1U
#define DSPIC33_CANFD_INT_H_RXOVIE_Access "rw"
#define DSPIC33_CANFD_INT_H_RXOVIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_RXOVIE_Pos) & DSPIC33_CANFD_INT_H_RXOVIE_Msk))
static inline uint16_t dspic33_canfd_int_h_rxovie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_RXOVIE_Msk) >> DSPIC33_CANFD_INT_H_RXOVIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_rxovie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_RXOVIE_Msk) | DSPIC33_CANFD_INT_H_RXOVIE_SET(value));
}
/* TXATIE: Enables the transmit attempt interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_TXATIE_Pos 10U
#define DSPIC33_CANFD_INT_H_TXATIE_Msk 0x0400U
#define DSPIC33_CANFD_INT_H_TXATIE_Width 1U
#define DSPIC33_CANFD_INT_H_TXATIE_Access "rw"
#define DSPIC33_CANFD_INT_H_TXATIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_TXATIE_Pos) & DSPIC33_CANFD_INT_H_TXATIE_Msk))
static inline uint16_t dspic33_canfd_int_h_txatie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_TXATIE_Msk) >> DSPIC33_CANFD_INT_H_TXATIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_txatie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_TXATIE_Msk) | DSPIC33_CANFD_INT_H_TXATIE_SET(value));
}
/* TEFIE: Enables the transmit event FIFO interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_TEFIE_Pos 4U
#define DSPIC33_CANFD_INT_H_TEFIE_Msk 0x0010U
#define DSPIC33_CANFD_INT_H_TEFIE_Width 1U
#define DSPIC33_CANFD_INT_H_TEFIE_Access "rw"
#define DSPIC33_CANFD_INT_H_TEFIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_TEFIE_Pos) & DSPIC33_CANFD_INT_H_TEFIE_Msk))
static inline uint16_t dspic33_canfd_int_h_tefie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_TEFIE_Msk) >> DSPIC33_CANFD_INT_H_TEFIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_tefie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_TEFIE_Msk) | DSPIC33_CANFD_INT_H_TEFIE_SET(value));
}
/* MODIE: Enables the mode change interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_MODIE_Pos 3U
#define DSPIC33_CANFD_INT_H_MODIE_Msk 0x0008U
#define DSPIC33_CANFD_INT_H_MODIE_Width 1U
#define DSPIC33_CANFD_INT_H_MODIE_Access "rw"
#define DSPIC33_CANFD_INT_H_MODIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_MODIE_Pos) & DSPIC33_CANFD_INT_H_MODIE_Msk))
static inline uint16_t dspic33_canfd_int_h_modie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_MODIE_Msk) >> DSPIC33_CANFD_INT_H_MODIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_modie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_MODIE_Msk) | DSPIC33_CANFD_INT_H_MODIE_SET(value));
}
/* TBCIE: Enables the timer interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_TBCIE_Pos 2U
#define DSPIC33_CANFD_INT_H_TBCIE_Msk 0x0004U
#define DSPIC33_CANFD_INT_H_TBCIE_Width 1U
#define DSPIC33_CANFD_INT_H_TBCIE_Access "rw"
#define DSPIC33_CANFD_INT_H_TBCIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_TBCIE_Pos) & DSPIC33_CANFD_INT_H_TBCIE_Msk))
static inline uint16_t dspic33_canfd_int_h_tbcie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_TBCIE_Msk) >> DSPIC33_CANFD_INT_H_TBCIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_tbcie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_TBCIE_Msk) | DSPIC33_CANFD_INT_H_TBCIE_SET(value));
}
/* RXIE: Enables the receive interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_RXIE_Pos 1U
#define DSPIC33_CANFD_INT_H_RXIE_Msk 0x0002U
#define DSPIC33_CANFD_INT_H_RXIE_Width 1U
#define DSPIC33_CANFD_INT_H_RXIE_Access "rw"
#define DSPIC33_CANFD_INT_H_RXIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_RXIE_Pos) & DSPIC33_CANFD_INT_H_RXIE_Msk))
static inline uint16_t dspic33_canfd_int_h_rxie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_RXIE_Msk) >> DSPIC33_CANFD_INT_H_RXIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_rxie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_RXIE_Msk) | DSPIC33_CANFD_INT_H_RXIE_SET(value));
}
/* TXIE: Enables the transmit interrupt. Access rw. */
#define DSPIC33_CANFD_INT_H_TXIE_Pos 0U
#define DSPIC33_CANFD_INT_H_TXIE_Msk 0x0001U
#define DSPIC33_CANFD_INT_H_TXIE_Width 1U
#define DSPIC33_CANFD_INT_H_TXIE_Access "rw"
#define DSPIC33_CANFD_INT_H_TXIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_INT_H_TXIE_Pos) & DSPIC33_CANFD_INT_H_TXIE_Msk))
static inline uint16_t dspic33_canfd_int_h_txie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_INT_H_TXIE_Msk) >> DSPIC33_CANFD_INT_H_TXIE_Pos);
}
static inline uint16_t dspic33_canfd_int_h_txie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_INT_H_TXIE_Msk) | DSPIC33_CANFD_INT_H_TXIE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_int_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->INTH;
    regs->INTH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* RXIFL: CAN Receive Interrupt Status Register Low.
 * Pending receive interrupts of FIFO 1 to 15. Clear them in the FIFO.
 * Contradictions of the manual: status_register_order, status_single_read.
 * Register 3-17; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_RXIF_L_OFFSET 0x020U
#define DSPIC33_CANFD_RXIF_L_RESET 0x0000U
#define DSPIC33_CANFD_RXIF_L_RESET_MASK 0xFFFFU
/* RFIF: OR of the enabled receive flags of FIFO n. Access ro. Lane 0 is number 1 in the first register. */
#define DSPIC33_CANFD_RXIF_L_RFIF_Pos(lane) (1U + 1U * (lane))
#define DSPIC33_CANFD_RXIF_L_RFIF_Msk(lane) ((uint16_t)(0x0002U << (1U * (lane))))
#define DSPIC33_CANFD_RXIF_L_RFIF_Lanes 15U
#define DSPIC33_CANFD_RXIF_L_RFIF_Width 1U
#define DSPIC33_CANFD_RXIF_L_RFIF_Access "ro"
static inline uint16_t dspic33_canfd_rxif_l_rfif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 15U);
    return (uint16_t)((reg & DSPIC33_CANFD_RXIF_L_RFIF_Msk(lane)) >> DSPIC33_CANFD_RXIF_L_RFIF_Pos(lane));
}

/* RXIFH: CAN Receive Interrupt Status Register High.
 * Pending receive interrupts of FIFO 16 to 31. Clear them in the FIFO.
 * Contradictions of the manual: status_single_read.
 * Register 3-18; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_RXIF_H_OFFSET 0x022U
#define DSPIC33_CANFD_RXIF_H_RESET 0x0000U
#define DSPIC33_CANFD_RXIF_H_RESET_MASK 0xFFFFU
/* RFIF: OR of the enabled receive flags of FIFO n. Access ro. Lane 0 is number 16 in the first register. */
#define DSPIC33_CANFD_RXIF_H_RFIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_RXIF_H_RFIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_RXIF_H_RFIF_Lanes 16U
#define DSPIC33_CANFD_RXIF_H_RFIF_Width 1U
#define DSPIC33_CANFD_RXIF_H_RFIF_Access "ro"
static inline uint16_t dspic33_canfd_rxif_h_rfif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_RXIF_H_RFIF_Msk(lane)) >> DSPIC33_CANFD_RXIF_H_RFIF_Pos(lane));
}

/* RXOVIFL: CAN Receive Overflow Interrupt Status Register Low.
 * Receive overflows of FIFO 1 to 15. Clear them in the FIFO.
 * Contradictions of the manual: status_register_order, status_single_read.
 * Register 3-19; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_RXOVIF_L_OFFSET 0x028U
#define DSPIC33_CANFD_RXOVIF_L_RESET 0x0000U
#define DSPIC33_CANFD_RXOVIF_L_RESET_MASK 0xFFFFU
/* RFOVIF: FIFO n has an overflow pending. Access ro. Lane 0 is number 1 in the first register. */
#define DSPIC33_CANFD_RXOVIF_L_RFOVIF_Pos(lane) (1U + 1U * (lane))
#define DSPIC33_CANFD_RXOVIF_L_RFOVIF_Msk(lane) ((uint16_t)(0x0002U << (1U * (lane))))
#define DSPIC33_CANFD_RXOVIF_L_RFOVIF_Lanes 15U
#define DSPIC33_CANFD_RXOVIF_L_RFOVIF_Width 1U
#define DSPIC33_CANFD_RXOVIF_L_RFOVIF_Access "ro"
static inline uint16_t dspic33_canfd_rxovif_l_rfovif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 15U);
    return (uint16_t)((reg & DSPIC33_CANFD_RXOVIF_L_RFOVIF_Msk(lane)) >> DSPIC33_CANFD_RXOVIF_L_RFOVIF_Pos(lane));
}

/* RXOVIFH: CAN Receive Overflow Interrupt Status Register High.
 * Receive overflows of FIFO 16 to 31. Clear them in the FIFO.
 * Contradictions of the manual: status_single_read.
 * Register 3-20; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_RXOVIF_H_OFFSET 0x02AU
#define DSPIC33_CANFD_RXOVIF_H_RESET 0x0000U
#define DSPIC33_CANFD_RXOVIF_H_RESET_MASK 0xFFFFU
/* RFOVIF: FIFO n has an overflow pending. Access ro. Lane 0 is number 16 in the first register. */
#define DSPIC33_CANFD_RXOVIF_H_RFOVIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_RXOVIF_H_RFOVIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_RXOVIF_H_RFOVIF_Lanes 16U
#define DSPIC33_CANFD_RXOVIF_H_RFOVIF_Width 1U
#define DSPIC33_CANFD_RXOVIF_H_RFOVIF_Access "ro"
static inline uint16_t dspic33_canfd_rxovif_h_rfovif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_RXOVIF_H_RFOVIF_Msk(lane)) >> DSPIC33_CANFD_RXOVIF_H_RFOVIF_Pos(lane));
}

/* TXIFL: CAN Transmit Interrupt Status Register Low.
 * Pending transmit interrupts of the queue and of FIFO 1 to 15. Clear them in the FIFO.
 * Contradictions of the manual: status_register_order, status_single_read.
 * Register 3-21; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXIF_L_OFFSET 0x024U
#define DSPIC33_CANFD_TXIF_L_RESET 0x0000U
#define DSPIC33_CANFD_TXIF_L_RESET_MASK 0xFFFFU
/* TFIF: OR of the enabled transmit flags of FIFO n; number 0 is the transmit queue. Access ro. Lane 0 is number
 * 0 in the first register.
 * Contradictions of the manual: table_12_1_flags.
 */
#define DSPIC33_CANFD_TXIF_L_TFIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_TXIF_L_TFIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_TXIF_L_TFIF_Lanes 16U
#define DSPIC33_CANFD_TXIF_L_TFIF_Width 1U
#define DSPIC33_CANFD_TXIF_L_TFIF_Access "ro"
static inline uint16_t dspic33_canfd_txif_l_tfif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXIF_L_TFIF_Msk(lane)) >> DSPIC33_CANFD_TXIF_L_TFIF_Pos(lane));
}

/* TXIFH: CAN Transmit Interrupt Status Register High.
 * Pending transmit interrupts of FIFO 16 to 31. Clear them in the FIFO.
 * Contradictions of the manual: status_single_read.
 * Register 3-22; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXIF_H_OFFSET 0x026U
#define DSPIC33_CANFD_TXIF_H_RESET 0x0000U
#define DSPIC33_CANFD_TXIF_H_RESET_MASK 0xFFFFU
/* TFIF: OR of the enabled transmit flags of FIFO n. Access ro. Lane 0 is number 16 in the first register. */
#define DSPIC33_CANFD_TXIF_H_TFIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_TXIF_H_TFIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_TXIF_H_TFIF_Lanes 16U
#define DSPIC33_CANFD_TXIF_H_TFIF_Width 1U
#define DSPIC33_CANFD_TXIF_H_TFIF_Access "ro"
static inline uint16_t dspic33_canfd_txif_h_tfif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXIF_H_TFIF_Msk(lane)) >> DSPIC33_CANFD_TXIF_H_TFIF_Pos(lane));
}

/* TXATIFL: CAN Transmit Attempt Interrupt Status Register Low.
 * Exhausted transmit attempts of the queue and of FIFO 1 to 15. Clear them in the FIFO or queue.
 * Contradictions of the manual: status_register_order, status_single_read.
 * Register 3-23; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXATIF_L_OFFSET 0x02CU
#define DSPIC33_CANFD_TXATIF_L_RESET 0x0000U
#define DSPIC33_CANFD_TXATIF_L_RESET_MASK 0xFFFFU
/* TFATIF: FIFO n has exhausted its attempts; number 0 is the transmit queue. Access ro. Lane 0 is number 0 in
 * the first register.
 */
#define DSPIC33_CANFD_TXATIF_L_TFATIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_TXATIF_L_TFATIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_TXATIF_L_TFATIF_Lanes 16U
#define DSPIC33_CANFD_TXATIF_L_TFATIF_Width 1U
#define DSPIC33_CANFD_TXATIF_L_TFATIF_Access "ro"
static inline uint16_t dspic33_canfd_txatif_l_tfatif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXATIF_L_TFATIF_Msk(lane)) >> DSPIC33_CANFD_TXATIF_L_TFATIF_Pos(lane));
}

/* TXATIFH: CAN Transmit Attempt Interrupt Status Register High.
 * Exhausted transmit attempts of FIFO 16 to 31. Clear them in the FIFO.
 * Contradictions of the manual: status_single_read.
 * Register 3-24; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXATIF_H_OFFSET 0x02EU
#define DSPIC33_CANFD_TXATIF_H_RESET 0x0000U
#define DSPIC33_CANFD_TXATIF_H_RESET_MASK 0xFFFFU
/* TFATIF: FIFO n has exhausted its attempts. Access ro. Lane 0 is number 16 in the first register. */
#define DSPIC33_CANFD_TXATIF_H_TFATIF_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_TXATIF_H_TFATIF_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_TXATIF_H_TFATIF_Lanes 16U
#define DSPIC33_CANFD_TXATIF_H_TFATIF_Width 1U
#define DSPIC33_CANFD_TXATIF_H_TFATIF_Access "ro"
static inline uint16_t dspic33_canfd_txatif_h_tfatif_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXATIF_H_TFATIF_Msk(lane)) >> DSPIC33_CANFD_TXATIF_H_TFATIF_Pos(lane));
}

/* TXREQL: CAN Transmit Request Register Low.
 * Transmission requests of the queue (bit 0) and of FIFO 1 to 15. Reads show which have transmissions pending.
 * Hazard: Write only the mask of the FIFOs to start. Zeros are ignored and cannot abort; a read-modify-write
 * would request again what hardware has just finished.
 * Register 3-25; §6.6; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXREQ_L_OFFSET 0x030U
#define DSPIC33_CANFD_TXREQ_L_RESET 0x0000U
#define DSPIC33_CANFD_TXREQ_L_RESET_MASK 0xFFFFU
/* TXREQ: Writing 1 requests transmission of everything queued in FIFO n; cleared by hardware when all of it is
 * sent. No effect on a FIFO configured for reception. Access w1s. A request: writing 1 makes it, writing 0 does
 * nothing, hardware clears it. Lane 0 is number 1 in the first register.
 * Contradictions of the manual: txreq_write_zero, txreq_numbering.
 * Register 3-25; §6.10
 */
#define DSPIC33_CANFD_TXREQ_L_TXREQ_Pos(lane) (1U + 1U * (lane))
#define DSPIC33_CANFD_TXREQ_L_TXREQ_Msk(lane) ((uint16_t)(0x0002U << (1U * (lane))))
#define DSPIC33_CANFD_TXREQ_L_TXREQ_Lanes 15U
#define DSPIC33_CANFD_TXREQ_L_TXREQ_Width 1U
#define DSPIC33_CANFD_TXREQ_L_TXREQ_Access "w1s"
static inline uint16_t dspic33_canfd_txreq_l_txreq_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 15U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXREQ_L_TXREQ_Msk(lane)) >> DSPIC33_CANFD_TXREQ_L_TXREQ_Pos(lane));
}
/* TXREQ0: Writing 1 requests transmission of everything in the transmit queue; cleared by hardware when all of
 * it is sent. Access w1s. A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
 * Contradictions of the manual: txreq_write_zero.
 * Register 3-25; §6.10
 */
#define DSPIC33_CANFD_TXREQ_L_TXREQ0_Pos 0U
#define DSPIC33_CANFD_TXREQ_L_TXREQ0_Msk 0x0001U
#define DSPIC33_CANFD_TXREQ_L_TXREQ0_Width 1U
#define DSPIC33_CANFD_TXREQ_L_TXREQ0_Access "w1s"
static inline uint16_t dspic33_canfd_txreq_l_txreq0_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXREQ_L_TXREQ0_Msk) >> DSPIC33_CANFD_TXREQ_L_TXREQ0_Pos);
}
/* Makes the given requests and withdraws none: one store, no read. */
static inline void dspic33_canfd_txreq_l_request(dspic33_canfd_regs_t *regs, uint16_t requests)
{
    regs->TXREQL = (uint16_t)((requests & 0xFFFFU));
}

/* TXREQH: CAN Transmit Request Register High.
 * Transmission requests of FIFO 16 to 31. Reads show which have transmissions pending.
 * Hazard: Write only the mask of the FIFOs to start. Zeros are ignored and cannot abort; a read-modify-write
 * would request again what hardware has just finished.
 * Register 3-26; §6.6; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXREQ_H_OFFSET 0x032U
#define DSPIC33_CANFD_TXREQ_H_RESET 0x0000U
#define DSPIC33_CANFD_TXREQ_H_RESET_MASK 0xFFFFU
/* TXREQ: Writing 1 requests transmission of everything queued in FIFO n; cleared by hardware when all of it is
 * sent. No effect on a FIFO configured for reception. Access w1s. A request: writing 1 makes it, writing 0 does
 * nothing, hardware clears it. Lane 0 is number 16 in the first register.
 * Contradictions of the manual: txreq_write_zero, txreq_numbering.
 * Register 3-26; §6.10
 */
#define DSPIC33_CANFD_TXREQ_H_TXREQ_Pos(lane) (0U + 1U * (lane))
#define DSPIC33_CANFD_TXREQ_H_TXREQ_Msk(lane) ((uint16_t)(0x0001U << (1U * (lane))))
#define DSPIC33_CANFD_TXREQ_H_TXREQ_Lanes 16U
#define DSPIC33_CANFD_TXREQ_H_TXREQ_Width 1U
#define DSPIC33_CANFD_TXREQ_H_TXREQ_Access "w1s"
static inline uint16_t dspic33_canfd_txreq_h_txreq_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 16U);
    return (uint16_t)((reg & DSPIC33_CANFD_TXREQ_H_TXREQ_Msk(lane)) >> DSPIC33_CANFD_TXREQ_H_TXREQ_Pos(lane));
}
/* Makes the given requests and withdraws none: one store, no read. */
static inline void dspic33_canfd_txreq_h_request(dspic33_canfd_regs_t *regs, uint16_t requests)
{
    regs->TXREQH = (uint16_t)((requests & 0xFFFFU));
}

/* FIFOBAL: CAN Message Memory Base Address Register Low.
 * Low half of the RAM address at which the message objects begin.
 * Hazard: The size of the memory used follows from the sizes of the event FIFO, the queue and the FIFOs; nothing
 * keeps the module inside a buffer that is too small.
 * A write is dangerous: The module writes received messages and transmit events to RAM from this address on,
 * whatever lies there. The memory has to hold everything that the sizes of the event FIFO, the queue and the
 * FIFOs lay out.
 * Contradictions of the manual: protected_fields.
 * Register 3-27; external: mcp251xfd_api (offset)
 */
#define DSPIC33_CANFD_FIFOBA_L_OFFSET 0x04CU
#define DSPIC33_CANFD_FIFOBA_L_RESET 0x0000U
#define DSPIC33_CANFD_FIFOBA_L_RESET_MASK 0xFFFFU
/* FIFOBA[15:2]: Bits 15 to 2 of the base address. Bits 1 and 0 are forced to 0, so that it is aligned to 32
 * bits. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration). Means value * 4
 * bytes.
 * Contradictions of the manual: fifoba_low_bits, fifoba_bit_table.
 */
#define DSPIC33_CANFD_FIFOBA_L_FIFOBA_Pos 2U
#define DSPIC33_CANFD_FIFOBA_L_FIFOBA_Msk 0xFFFCU
#define DSPIC33_CANFD_FIFOBA_L_FIFOBA_Width 14U
#define DSPIC33_CANFD_FIFOBA_L_FIFOBA_Access "rw:config"
#define DSPIC33_CANFD_FIFOBA_L_FIFOBA_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFOBA_L_FIFOBA_Pos) & DSPIC33_CANFD_FIFOBA_L_FIFOBA_Msk))
static inline uint16_t dspic33_canfd_fifoba_l_fifoba_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFOBA_L_FIFOBA_Msk) >> DSPIC33_CANFD_FIFOBA_L_FIFOBA_Pos);
}
static inline uint16_t dspic33_canfd_fifoba_l_fifoba_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 16383U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFOBA_L_FIFOBA_Msk) | DSPIC33_CANFD_FIFOBA_L_FIFOBA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_fifoba_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->FIFOBAL;
    regs->FIFOBAL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FIFOBAH: CAN Message Memory Base Address Register High.
 * High half of the RAM address at which the message objects begin.
 * A write is dangerous: The module writes received messages and transmit events to RAM from this address on,
 * whatever lies there. The memory has to hold everything that the sizes of the event FIFO, the queue and the
 * FIFOs lay out.
 * Contradictions of the manual: protected_fields.
 * Register 3-28; external: mcp251xfd_api (offset)
 */
#define DSPIC33_CANFD_FIFOBA_H_OFFSET 0x04EU
#define DSPIC33_CANFD_FIFOBA_H_RESET 0x0000U
#define DSPIC33_CANFD_FIFOBA_H_RESET_MASK 0xFFFFU
/* FIFOBA[31:16]: Bits 31 to 16 of the base address. Access rw:config. A write has an effect only if config
 * (CONH.OPMOD == configuration).
 */
#define DSPIC33_CANFD_FIFOBA_H_FIFOBA_Pos 0U
#define DSPIC33_CANFD_FIFOBA_H_FIFOBA_Msk 0xFFFFU
#define DSPIC33_CANFD_FIFOBA_H_FIFOBA_Width 16U
#define DSPIC33_CANFD_FIFOBA_H_FIFOBA_Access "rw:config"
#define DSPIC33_CANFD_FIFOBA_H_FIFOBA_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFOBA_H_FIFOBA_Pos) & DSPIC33_CANFD_FIFOBA_H_FIFOBA_Msk))
static inline uint16_t dspic33_canfd_fifoba_h_fifoba_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFOBA_H_FIFOBA_Msk) >> DSPIC33_CANFD_FIFOBA_H_FIFOBA_Pos);
}
static inline uint16_t dspic33_canfd_fifoba_h_fifoba_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFOBA_H_FIFOBA_Msk) | DSPIC33_CANFD_FIFOBA_H_FIFOBA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_fifoba_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->FIFOBAH;
    regs->FIFOBAH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TXQCONL: CAN Transmit Queue Control Register Low.
 * Requests and interrupt enables of the transmit queue.
 * Hazard: Writing TXREQ 0 while it is 1 requests an abort. A write meant for another bit has to carry TXREQ 1
 * while the queue is transmitting.
 * Hazard: When appending while the queue is transmitting, set UINC and TXREQ in the same write; TXREQ is cleared
 * when the queue runs empty.
 * Hazard: Before FRESET no transmission may be pending; afterwards wait until FRESET reads 0. In Configuration
 * mode it stays 1.
 * Hazard: Writing into a full queue can damage a message that is being sent; check TXQNIF first.
 * Register 3-29; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXQCON_L_OFFSET 0x050U
#define DSPIC33_CANFD_TXQCON_L_RESET 0x0480U
#define DSPIC33_CANFD_TXQCON_L_RESET_MASK 0xFFFFU
/* FRESET: Writing 1 resets the queue and its status register, hardware clears it when done; writing 0 has no
 * effect. Held at 1 in Configuration mode. Access w1s. A request: writing 1 makes it, writing 0 does nothing,
 * hardware clears it.
 * Register 3-29; §6.15; §4.2
 */
#define DSPIC33_CANFD_TXQCON_L_FRESET_Pos 10U
#define DSPIC33_CANFD_TXQCON_L_FRESET_Msk 0x0400U
#define DSPIC33_CANFD_TXQCON_L_FRESET_Width 1U
#define DSPIC33_CANFD_TXQCON_L_FRESET_Access "w1s"
static inline uint16_t dspic33_canfd_txqcon_l_freset_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_FRESET_Msk) >> DSPIC33_CANFD_TXQCON_L_FRESET_Pos);
}
/* TXREQ: Writing 1 requests transmission; hardware clears it when all messages in the queue are sent, or when
 * attempts are exhausted, aborted or stopped by a DLC mismatch. Writing 0 while it is 1 requests an abort; it
 * then stays 1 until aborted or sent. Access rwhc. A request that can be withdrawn: 1 requests, 0 aborts,
 * hardware clears it.
 * Contradictions of the manual: abort_register.
 * Register 3-29; §6.5; §6.10
 */
#define DSPIC33_CANFD_TXQCON_L_TXREQ_Pos 9U
#define DSPIC33_CANFD_TXQCON_L_TXREQ_Msk 0x0200U
#define DSPIC33_CANFD_TXQCON_L_TXREQ_Width 1U
#define DSPIC33_CANFD_TXQCON_L_TXREQ_Access "rwhc"
#define DSPIC33_CANFD_TXQCON_L_TXREQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_L_TXREQ_Pos) & DSPIC33_CANFD_TXQCON_L_TXREQ_Msk))
static inline uint16_t dspic33_canfd_txqcon_l_txreq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_TXREQ_Msk) >> DSPIC33_CANFD_TXQCON_L_TXREQ_Pos);
}
/* UINC: Writing 1 hands the message just loaded to the queue and moves the user address to the next free object.
 * Access w1s. A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
 */
#define DSPIC33_CANFD_TXQCON_L_UINC_Pos 8U
#define DSPIC33_CANFD_TXQCON_L_UINC_Msk 0x0100U
#define DSPIC33_CANFD_TXQCON_L_UINC_Width 1U
#define DSPIC33_CANFD_TXQCON_L_UINC_Access "w1s"
static inline uint16_t dspic33_canfd_txqcon_l_uinc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_UINC_Msk) >> DSPIC33_CANFD_TXQCON_L_UINC_Pos);
}
/* TXEN: Always 1: the queue transmits. Access ro.
 * Contradictions of the manual: txqcon_txen.
 */
#define DSPIC33_CANFD_TXQCON_L_TXEN_Pos 7U
#define DSPIC33_CANFD_TXQCON_L_TXEN_Msk 0x0080U
#define DSPIC33_CANFD_TXQCON_L_TXEN_Width 1U
#define DSPIC33_CANFD_TXQCON_L_TXEN_Access "ro"
static inline uint16_t dspic33_canfd_txqcon_l_txen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_TXEN_Msk) >> DSPIC33_CANFD_TXQCON_L_TXEN_Pos);
}
/* TXATIE: Enables the attempts exhausted interrupt of the queue. Access rw. */
#define DSPIC33_CANFD_TXQCON_L_TXATIE_Pos 4U
#define DSPIC33_CANFD_TXQCON_L_TXATIE_Msk 0x0010U
#define DSPIC33_CANFD_TXQCON_L_TXATIE_Width 1U
#define DSPIC33_CANFD_TXQCON_L_TXATIE_Access "rw"
#define DSPIC33_CANFD_TXQCON_L_TXATIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_L_TXATIE_Pos) & DSPIC33_CANFD_TXQCON_L_TXATIE_Msk))
static inline uint16_t dspic33_canfd_txqcon_l_txatie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_TXATIE_Msk) >> DSPIC33_CANFD_TXQCON_L_TXATIE_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_l_txatie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_L_TXATIE_Msk) | DSPIC33_CANFD_TXQCON_L_TXATIE_SET(value));
}
/* TXQEIE: Enables the interrupt for an empty queue. Access rw. */
#define DSPIC33_CANFD_TXQCON_L_TXQEIE_Pos 2U
#define DSPIC33_CANFD_TXQCON_L_TXQEIE_Msk 0x0004U
#define DSPIC33_CANFD_TXQCON_L_TXQEIE_Width 1U
#define DSPIC33_CANFD_TXQCON_L_TXQEIE_Access "rw"
#define DSPIC33_CANFD_TXQCON_L_TXQEIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_L_TXQEIE_Pos) & DSPIC33_CANFD_TXQCON_L_TXQEIE_Msk))
static inline uint16_t dspic33_canfd_txqcon_l_txqeie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_TXQEIE_Msk) >> DSPIC33_CANFD_TXQCON_L_TXQEIE_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_l_txqeie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_L_TXQEIE_Msk) | DSPIC33_CANFD_TXQCON_L_TXQEIE_SET(value));
}
/* TXQNIE: Enables the interrupt for a queue that is not full. Access rw. */
#define DSPIC33_CANFD_TXQCON_L_TXQNIE_Pos 0U
#define DSPIC33_CANFD_TXQCON_L_TXQNIE_Msk 0x0001U
#define DSPIC33_CANFD_TXQCON_L_TXQNIE_Width 1U
#define DSPIC33_CANFD_TXQCON_L_TXQNIE_Access "rw"
#define DSPIC33_CANFD_TXQCON_L_TXQNIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_L_TXQNIE_Pos) & DSPIC33_CANFD_TXQCON_L_TXQNIE_Msk))
static inline uint16_t dspic33_canfd_txqcon_l_txqnie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_L_TXQNIE_Msk) >> DSPIC33_CANFD_TXQCON_L_TXQNIE_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_l_txqnie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_L_TXQNIE_Msk) | DSPIC33_CANFD_TXQCON_L_TXQNIE_SET(value));
}
/* No read-modify-write: no value written to TXREQ leaves it alone. Compose the whole value and store it. */

/* TXQCONH: CAN Transmit Queue Control Register High.
 * Size, retransmission attempts and priority of the transmit queue.
 * Register 3-30; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXQCON_H_OFFSET 0x052U
#define DSPIC33_CANFD_TXQCON_H_RESET 0x0060U
#define DSPIC33_CANFD_TXQCON_H_RESET_MASK 0xFFFFU
/* PLSIZE: Payload size of every message object in the queue. Access rw:config. A write has an effect only if
 * config (CONH.OPMOD == configuration).
 */
#define DSPIC33_CANFD_TXQCON_H_PLSIZE_Pos 13U
#define DSPIC33_CANFD_TXQCON_H_PLSIZE_Msk 0xE000U
#define DSPIC33_CANFD_TXQCON_H_PLSIZE_Width 3U
#define DSPIC33_CANFD_TXQCON_H_PLSIZE_Access "rw:config"
#define DSPIC33_CANFD_TXQCON_H_PLSIZE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_H_PLSIZE_Pos) & DSPIC33_CANFD_TXQCON_H_PLSIZE_Msk))
static inline uint16_t dspic33_canfd_txqcon_h_plsize_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_H_PLSIZE_Msk) >> DSPIC33_CANFD_TXQCON_H_PLSIZE_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_h_plsize_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_H_PLSIZE_Msk) | DSPIC33_CANFD_TXQCON_H_PLSIZE_SET(value));
}
/* FSIZE: Depth of the queue, 1 to 32 messages. Access rw:config. A write has an effect only if config
 * (CONH.OPMOD == configuration). Means value + 1 messages.
 */
#define DSPIC33_CANFD_TXQCON_H_FSIZE_Pos 8U
#define DSPIC33_CANFD_TXQCON_H_FSIZE_Msk 0x1F00U
#define DSPIC33_CANFD_TXQCON_H_FSIZE_Width 5U
#define DSPIC33_CANFD_TXQCON_H_FSIZE_Access "rw:config"
#define DSPIC33_CANFD_TXQCON_H_FSIZE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_H_FSIZE_Pos) & DSPIC33_CANFD_TXQCON_H_FSIZE_Msk))
static inline uint16_t dspic33_canfd_txqcon_h_fsize_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_H_FSIZE_Msk) >> DSPIC33_CANFD_TXQCON_H_FSIZE_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_h_fsize_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_H_FSIZE_Msk) | DSPIC33_CANFD_TXQCON_H_FSIZE_SET(value));
}
/* TXAT: Retransmission attempts; used only while CONH.RTXAT is set. Access rw. */
#define DSPIC33_CANFD_TXQCON_H_TXAT_Pos 5U
#define DSPIC33_CANFD_TXQCON_H_TXAT_Msk 0x0060U
#define DSPIC33_CANFD_TXQCON_H_TXAT_Width 2U
#define DSPIC33_CANFD_TXQCON_H_TXAT_Access "rw"
#define DSPIC33_CANFD_TXQCON_H_TXAT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_H_TXAT_Pos) & DSPIC33_CANFD_TXQCON_H_TXAT_Msk))
static inline uint16_t dspic33_canfd_txqcon_h_txat_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_H_TXAT_Msk) >> DSPIC33_CANFD_TXQCON_H_TXAT_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_h_txat_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_H_TXAT_Msk) | DSPIC33_CANFD_TXQCON_H_TXAT_SET(value));
}
/* TXPRI: Priority of the queue against the FIFOs, 0 lowest to 31 highest. At equal priority the queue goes
 * first. Priorities are compared anew after every message. Access rw.
 * Register 3-30; §6.7
 */
#define DSPIC33_CANFD_TXQCON_H_TXPRI_Pos 0U
#define DSPIC33_CANFD_TXQCON_H_TXPRI_Msk 0x001FU
#define DSPIC33_CANFD_TXQCON_H_TXPRI_Width 5U
#define DSPIC33_CANFD_TXQCON_H_TXPRI_Access "rw"
#define DSPIC33_CANFD_TXQCON_H_TXPRI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TXQCON_H_TXPRI_Pos) & DSPIC33_CANFD_TXQCON_H_TXPRI_Msk))
static inline uint16_t dspic33_canfd_txqcon_h_txpri_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQCON_H_TXPRI_Msk) >> DSPIC33_CANFD_TXQCON_H_TXPRI_Pos);
}
static inline uint16_t dspic33_canfd_txqcon_h_txpri_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TXQCON_H_TXPRI_Msk) | DSPIC33_CANFD_TXQCON_H_TXPRI_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_txqcon_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TXQCONH;
    regs->TXQCONH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TXQSTA: CAN Transmit Queue Status Register.
 * Status of the transmit queue.
 * Register 3-31; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXQSTA_OFFSET 0x054U
#define DSPIC33_CANFD_TXQSTA_RESET 0x0005U
#define DSPIC33_CANFD_TXQSTA_RESET_MASK 0xFFFFU
/* TXQCI: Index of the message the queue will attempt to send next, counted from 0. Recomputed at every
 * transmission and request, not linear; software need not use it. Access ro.
 * Register 3-31; §10.4
 */
#define DSPIC33_CANFD_TXQSTA_TXQCI_Pos 8U
#define DSPIC33_CANFD_TXQSTA_TXQCI_Msk 0x1F00U
#define DSPIC33_CANFD_TXQSTA_TXQCI_Width 5U
#define DSPIC33_CANFD_TXQSTA_TXQCI_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txqci_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXQCI_Msk) >> DSPIC33_CANFD_TXQSTA_TXQCI_Pos);
}
/* TXABT: The message was aborted (1) or completed (0). Renewed with every message that completes or aborts, and
 * by a reset of the queue. Access ro.
 * Contradictions of the manual: txabt_reset.
 */
#define DSPIC33_CANFD_TXQSTA_TXABT_Pos 7U
#define DSPIC33_CANFD_TXQSTA_TXABT_Msk 0x0080U
#define DSPIC33_CANFD_TXQSTA_TXABT_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXABT_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txabt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXABT_Msk) >> DSPIC33_CANFD_TXQSTA_TXABT_Pos);
}
/* TXLARB: Another node won the arbitration against the message. Renewed with every message that completes or
 * aborts, and by a reset of the queue. Access ro.
 */
#define DSPIC33_CANFD_TXQSTA_TXLARB_Pos 6U
#define DSPIC33_CANFD_TXQSTA_TXLARB_Msk 0x0040U
#define DSPIC33_CANFD_TXQSTA_TXLARB_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXLARB_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txlarb_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXLARB_Msk) >> DSPIC33_CANFD_TXQSTA_TXLARB_Pos);
}
/* TXERR: Sending the message met a bus error. Renewed with every message that completes or aborts, and by a
 * reset of the queue. Access ro.
 */
#define DSPIC33_CANFD_TXQSTA_TXERR_Pos 5U
#define DSPIC33_CANFD_TXQSTA_TXERR_Msk 0x0020U
#define DSPIC33_CANFD_TXQSTA_TXERR_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXERR_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXERR_Msk) >> DSPIC33_CANFD_TXQSTA_TXERR_Pos);
}
/* TXATIF: The transmit attempts are exhausted. Cleared by the application. Access w0c. A flag: writing 0 clears
 * it, writing 1 does nothing.
 * Contradictions of the manual: txatif_cause.
 * Register 3-31; §12.1.5
 */
#define DSPIC33_CANFD_TXQSTA_TXATIF_Pos 4U
#define DSPIC33_CANFD_TXQSTA_TXATIF_Msk 0x0010U
#define DSPIC33_CANFD_TXQSTA_TXATIF_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXATIF_Access "w0c"
static inline uint16_t dspic33_canfd_txqsta_txatif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXATIF_Msk) >> DSPIC33_CANFD_TXQSTA_TXATIF_Pos);
}
/* TXQEIF: The queue is empty. Access ro. */
#define DSPIC33_CANFD_TXQSTA_TXQEIF_Pos 2U
#define DSPIC33_CANFD_TXQSTA_TXQEIF_Msk 0x0004U
#define DSPIC33_CANFD_TXQSTA_TXQEIF_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXQEIF_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txqeif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXQEIF_Msk) >> DSPIC33_CANFD_TXQSTA_TXQEIF_Pos);
}
/* TXQNIF: The queue is not full: there is room for another message. Access ro. */
#define DSPIC33_CANFD_TXQSTA_TXQNIF_Pos 0U
#define DSPIC33_CANFD_TXQSTA_TXQNIF_Msk 0x0001U
#define DSPIC33_CANFD_TXQSTA_TXQNIF_Width 1U
#define DSPIC33_CANFD_TXQSTA_TXQNIF_Access "ro"
static inline uint16_t dspic33_canfd_txqsta_txqnif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQSTA_TXQNIF_Msk) >> DSPIC33_CANFD_TXQSTA_TXQNIF_Pos);
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_canfd_txqsta_clear(dspic33_canfd_regs_t *regs, uint16_t flags)
{
    regs->TXQSTA = (uint16_t)(0x0010U & (uint16_t)~flags);
}

/* TEFCONL: CAN Transmit Event FIFO Control Register Low.
 * Requests, timestamping and interrupt enables of the transmit event FIFO.
 * Hazard: After setting FRESET wait until it reads 0. In Configuration mode it stays 1.
 * Register 3-35; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TEFCON_L_OFFSET 0x040U
#define DSPIC33_CANFD_TEFCON_L_RESET 0x0400U
#define DSPIC33_CANFD_TEFCON_L_RESET_MASK 0xFFFFU
/* FRESET: Writing 1 resets the event FIFO and its status register, hardware clears it when done; writing 0 has
 * no effect. Held at 1 in Configuration mode. Access w1s. A request: writing 1 makes it, writing 0 does nothing,
 * hardware clears it.
 * Register 3-35; §7.1.1; §4.2
 */
#define DSPIC33_CANFD_TEFCON_L_FRESET_Pos 10U
#define DSPIC33_CANFD_TEFCON_L_FRESET_Msk 0x0400U
#define DSPIC33_CANFD_TEFCON_L_FRESET_Width 1U
#define DSPIC33_CANFD_TEFCON_L_FRESET_Access "w1s"
static inline uint16_t dspic33_canfd_tefcon_l_freset_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_FRESET_Msk) >> DSPIC33_CANFD_TEFCON_L_FRESET_Pos);
}
/* UINC: Writing 1 releases the event just read and moves the user address to the next. Access w1s. A request:
 * writing 1 makes it, writing 0 does nothing, hardware clears it.
 */
#define DSPIC33_CANFD_TEFCON_L_UINC_Pos 8U
#define DSPIC33_CANFD_TEFCON_L_UINC_Msk 0x0100U
#define DSPIC33_CANFD_TEFCON_L_UINC_Width 1U
#define DSPIC33_CANFD_TEFCON_L_UINC_Access "w1s"
static inline uint16_t dspic33_canfd_tefcon_l_uinc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_UINC_Msk) >> DSPIC33_CANFD_TEFCON_L_UINC_Pos);
}
/* TEFTSEN: Timestamps the events; every object grows by 4 bytes. Access rw:config. A write has an effect only if
 * config (CONH.OPMOD == configuration).
 */
#define DSPIC33_CANFD_TEFCON_L_TEFTSEN_Pos 5U
#define DSPIC33_CANFD_TEFCON_L_TEFTSEN_Msk 0x0020U
#define DSPIC33_CANFD_TEFCON_L_TEFTSEN_Width 1U
#define DSPIC33_CANFD_TEFCON_L_TEFTSEN_Access "rw:config"
#define DSPIC33_CANFD_TEFCON_L_TEFTSEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_L_TEFTSEN_Pos) & DSPIC33_CANFD_TEFCON_L_TEFTSEN_Msk))
static inline uint16_t dspic33_canfd_tefcon_l_teftsen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_TEFTSEN_Msk) >> DSPIC33_CANFD_TEFCON_L_TEFTSEN_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_l_teftsen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_L_TEFTSEN_Msk) | DSPIC33_CANFD_TEFCON_L_TEFTSEN_SET(value));
}
/* TEFOVIE: Enables the overflow interrupt. Access rw. */
#define DSPIC33_CANFD_TEFCON_L_TEFOVIE_Pos 3U
#define DSPIC33_CANFD_TEFCON_L_TEFOVIE_Msk 0x0008U
#define DSPIC33_CANFD_TEFCON_L_TEFOVIE_Width 1U
#define DSPIC33_CANFD_TEFCON_L_TEFOVIE_Access "rw"
#define DSPIC33_CANFD_TEFCON_L_TEFOVIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_L_TEFOVIE_Pos) & DSPIC33_CANFD_TEFCON_L_TEFOVIE_Msk))
static inline uint16_t dspic33_canfd_tefcon_l_tefovie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_TEFOVIE_Msk) >> DSPIC33_CANFD_TEFCON_L_TEFOVIE_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_l_tefovie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_L_TEFOVIE_Msk) | DSPIC33_CANFD_TEFCON_L_TEFOVIE_SET(value));
}
/* TEFFIE: Enables the full interrupt. Access rw. */
#define DSPIC33_CANFD_TEFCON_L_TEFFIE_Pos 2U
#define DSPIC33_CANFD_TEFCON_L_TEFFIE_Msk 0x0004U
#define DSPIC33_CANFD_TEFCON_L_TEFFIE_Width 1U
#define DSPIC33_CANFD_TEFCON_L_TEFFIE_Access "rw"
#define DSPIC33_CANFD_TEFCON_L_TEFFIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_L_TEFFIE_Pos) & DSPIC33_CANFD_TEFCON_L_TEFFIE_Msk))
static inline uint16_t dspic33_canfd_tefcon_l_teffie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_TEFFIE_Msk) >> DSPIC33_CANFD_TEFCON_L_TEFFIE_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_l_teffie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_L_TEFFIE_Msk) | DSPIC33_CANFD_TEFCON_L_TEFFIE_SET(value));
}
/* TEFHIE: Enables the half full interrupt. Access rw. */
#define DSPIC33_CANFD_TEFCON_L_TEFHIE_Pos 1U
#define DSPIC33_CANFD_TEFCON_L_TEFHIE_Msk 0x0002U
#define DSPIC33_CANFD_TEFCON_L_TEFHIE_Width 1U
#define DSPIC33_CANFD_TEFCON_L_TEFHIE_Access "rw"
#define DSPIC33_CANFD_TEFCON_L_TEFHIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_L_TEFHIE_Pos) & DSPIC33_CANFD_TEFCON_L_TEFHIE_Msk))
static inline uint16_t dspic33_canfd_tefcon_l_tefhie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_TEFHIE_Msk) >> DSPIC33_CANFD_TEFCON_L_TEFHIE_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_l_tefhie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_L_TEFHIE_Msk) | DSPIC33_CANFD_TEFCON_L_TEFHIE_SET(value));
}
/* TEFNEIE: Enables the not empty interrupt. Access rw. */
#define DSPIC33_CANFD_TEFCON_L_TEFNEIE_Pos 0U
#define DSPIC33_CANFD_TEFCON_L_TEFNEIE_Msk 0x0001U
#define DSPIC33_CANFD_TEFCON_L_TEFNEIE_Width 1U
#define DSPIC33_CANFD_TEFCON_L_TEFNEIE_Access "rw"
#define DSPIC33_CANFD_TEFCON_L_TEFNEIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_L_TEFNEIE_Pos) & DSPIC33_CANFD_TEFCON_L_TEFNEIE_Msk))
static inline uint16_t dspic33_canfd_tefcon_l_tefneie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_L_TEFNEIE_Msk) >> DSPIC33_CANFD_TEFCON_L_TEFNEIE_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_l_tefneie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_L_TEFNEIE_Msk) | DSPIC33_CANFD_TEFCON_L_TEFNEIE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tefcon_l_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TEFCONL;
    value = (uint16_t)((value & (uint16_t)~0x0500U) | 0x0000U);
    regs->TEFCONL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TEFCONH: CAN Transmit Event FIFO Control Register High.
 * Depth of the transmit event FIFO.
 * Register 3-36; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TEFCON_H_OFFSET 0x042U
#define DSPIC33_CANFD_TEFCON_H_RESET 0x0000U
#define DSPIC33_CANFD_TEFCON_H_RESET_MASK 0xFFFFU
/* FSIZE: Depth of the event FIFO, 1 to 32 events. Access rw:config. A write has an effect only if config
 * (CONH.OPMOD == configuration). Means value + 1 messages.
 */
#define DSPIC33_CANFD_TEFCON_H_FSIZE_Pos 8U
#define DSPIC33_CANFD_TEFCON_H_FSIZE_Msk 0x1F00U
#define DSPIC33_CANFD_TEFCON_H_FSIZE_Width 5U
#define DSPIC33_CANFD_TEFCON_H_FSIZE_Access "rw:config"
#define DSPIC33_CANFD_TEFCON_H_FSIZE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEFCON_H_FSIZE_Pos) & DSPIC33_CANFD_TEFCON_H_FSIZE_Msk))
static inline uint16_t dspic33_canfd_tefcon_h_fsize_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFCON_H_FSIZE_Msk) >> DSPIC33_CANFD_TEFCON_H_FSIZE_Pos);
}
static inline uint16_t dspic33_canfd_tefcon_h_fsize_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEFCON_H_FSIZE_Msk) | DSPIC33_CANFD_TEFCON_H_FSIZE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_tefcon_h_modify(dspic33_canfd_regs_t *regs, uint16_t clear, uint16_t set)
{
    uint16_t value = regs->TEFCONH;
    regs->TEFCONH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* TEFSTA: CAN Transmit Event FIFO Status Register.
 * Status of the transmit event FIFO.
 * Register 3-37; §10.1.4; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TEFSTA_OFFSET 0x044U
#define DSPIC33_CANFD_TEFSTA_RESET 0x0000U
#define DSPIC33_CANFD_TEFSTA_RESET_MASK 0xFFFFU
/* TEFOVIF: An event was lost because the FIFO was full. Cleared by the application. Access w0c. A flag: writing
 * 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: tefovif_reset.
 */
#define DSPIC33_CANFD_TEFSTA_TEFOVIF_Pos 3U
#define DSPIC33_CANFD_TEFSTA_TEFOVIF_Msk 0x0008U
#define DSPIC33_CANFD_TEFSTA_TEFOVIF_Width 1U
#define DSPIC33_CANFD_TEFSTA_TEFOVIF_Access "w0c"
static inline uint16_t dspic33_canfd_tefsta_tefovif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFSTA_TEFOVIF_Msk) >> DSPIC33_CANFD_TEFSTA_TEFOVIF_Pos);
}
/* TEFFIF: The FIFO is full. Access ro. */
#define DSPIC33_CANFD_TEFSTA_TEFFIF_Pos 2U
#define DSPIC33_CANFD_TEFSTA_TEFFIF_Msk 0x0004U
#define DSPIC33_CANFD_TEFSTA_TEFFIF_Width 1U
#define DSPIC33_CANFD_TEFSTA_TEFFIF_Access "ro"
static inline uint16_t dspic33_canfd_tefsta_teffif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFSTA_TEFFIF_Msk) >> DSPIC33_CANFD_TEFSTA_TEFFIF_Pos);
}
/* TEFHIF: The FIFO is at least half full. Access ro. */
#define DSPIC33_CANFD_TEFSTA_TEFHIF_Pos 1U
#define DSPIC33_CANFD_TEFSTA_TEFHIF_Msk 0x0002U
#define DSPIC33_CANFD_TEFSTA_TEFHIF_Width 1U
#define DSPIC33_CANFD_TEFSTA_TEFHIF_Access "ro"
static inline uint16_t dspic33_canfd_tefsta_tefhif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFSTA_TEFHIF_Msk) >> DSPIC33_CANFD_TEFSTA_TEFHIF_Pos);
}
/* TEFNEIF: The FIFO holds at least one event. Access ro. */
#define DSPIC33_CANFD_TEFSTA_TEFNEIF_Pos 0U
#define DSPIC33_CANFD_TEFSTA_TEFNEIF_Msk 0x0001U
#define DSPIC33_CANFD_TEFSTA_TEFNEIF_Width 1U
#define DSPIC33_CANFD_TEFSTA_TEFNEIF_Access "ro"
static inline uint16_t dspic33_canfd_tefsta_tefneif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFSTA_TEFNEIF_Msk) >> DSPIC33_CANFD_TEFSTA_TEFNEIF_Pos);
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_canfd_tefsta_clear(dspic33_canfd_regs_t *regs, uint16_t flags)
{
    regs->TEFSTA = (uint16_t)(0x0008U & (uint16_t)~flags);
}

/* TEFUAL: CAN Transmit Event FIFO User Address Register Low.
 * Low half of the RAM address of the next event to read.
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Contradictions of the manual: tef_address.
 * Register 3-40; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TEFUA_L_OFFSET 0x048U
#define DSPIC33_CANFD_TEFUA_L_RESET 0x0000U
#define DSPIC33_CANFD_TEFUA_L_RESET_MASK 0x0000U
/* TEFUA[15:0]: Bits 15 to 0 of the address of the next event to read (tail). Access ro. */
#define DSPIC33_CANFD_TEFUA_L_TEFUA_Pos 0U
#define DSPIC33_CANFD_TEFUA_L_TEFUA_Msk 0xFFFFU
#define DSPIC33_CANFD_TEFUA_L_TEFUA_Width 16U
#define DSPIC33_CANFD_TEFUA_L_TEFUA_Access "ro"
static inline uint16_t dspic33_canfd_tefua_l_tefua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFUA_L_TEFUA_Msk) >> DSPIC33_CANFD_TEFUA_L_TEFUA_Pos);
}

/* TEFUAH: CAN Transmit Event FIFO User Address Register High.
 * High half of the RAM address of the next event to read.
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Contradictions of the manual: tef_address.
 * Register 3-41; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TEFUA_H_OFFSET 0x04AU
#define DSPIC33_CANFD_TEFUA_H_RESET 0x0000U
#define DSPIC33_CANFD_TEFUA_H_RESET_MASK 0x0000U
/* TEFUA[31:16]: Bits 31 to 16 of the address of the next event to read (tail). Access ro. */
#define DSPIC33_CANFD_TEFUA_H_TEFUA_Pos 0U
#define DSPIC33_CANFD_TEFUA_H_TEFUA_Msk 0xFFFFU
#define DSPIC33_CANFD_TEFUA_H_TEFUA_Width 16U
#define DSPIC33_CANFD_TEFUA_H_TEFUA_Access "ro"
static inline uint16_t dspic33_canfd_tefua_h_tefua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEFUA_H_TEFUA_Msk) >> DSPIC33_CANFD_TEFUA_H_TEFUA_Pos);
}

/* TXQUAL: CAN Transmit Queue User Address Register Low.
 * Low half of the RAM address where the next message for the queue is to be written.
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Register 3-42; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXQUA_L_OFFSET 0x058U
#define DSPIC33_CANFD_TXQUA_L_RESET 0x0000U
#define DSPIC33_CANFD_TXQUA_L_RESET_MASK 0x0000U
/* TXQUA[15:0]: Bits 15 to 0 of the address of the next free object of the queue. Access ro. */
#define DSPIC33_CANFD_TXQUA_L_TXQUA_Pos 0U
#define DSPIC33_CANFD_TXQUA_L_TXQUA_Msk 0xFFFFU
#define DSPIC33_CANFD_TXQUA_L_TXQUA_Width 16U
#define DSPIC33_CANFD_TXQUA_L_TXQUA_Access "ro"
static inline uint16_t dspic33_canfd_txqua_l_txqua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQUA_L_TXQUA_Msk) >> DSPIC33_CANFD_TXQUA_L_TXQUA_Pos);
}

/* TXQUAH: CAN Transmit Queue User Address Register High.
 * High half of the RAM address where the next message for the queue is to be written.
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Register 3-43; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TXQUA_H_OFFSET 0x05AU
#define DSPIC33_CANFD_TXQUA_H_RESET 0x0000U
#define DSPIC33_CANFD_TXQUA_H_RESET_MASK 0x0000U
/* TXQUA[31:16]: Bits 31 to 16 of the address of the next free object of the queue. Access ro. */
#define DSPIC33_CANFD_TXQUA_H_TXQUA_Pos 0U
#define DSPIC33_CANFD_TXQUA_H_TXQUA_Msk 0xFFFFU
#define DSPIC33_CANFD_TXQUA_H_TXQUA_Width 16U
#define DSPIC33_CANFD_TXQUA_H_TXQUA_Access "ro"
static inline uint16_t dspic33_canfd_txqua_h_txqua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TXQUA_H_TXQUA_Msk) >> DSPIC33_CANFD_TXQUA_H_TXQUA_Pos);
}

/* TRECL: CAN Transmit/Receive Error Count Register Low.
 * Error counters as ISO 11898-1:2015 defines them. Reset on leaving Configuration mode and on recovery from bus
 * off.
 * Contradictions of the manual: trec_reset_txbo.
 * Register 3-44; §13.0 p.116; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TREC_L_OFFSET 0x034U
#define DSPIC33_CANFD_TREC_L_RESET 0x0000U
#define DSPIC33_CANFD_TREC_L_RESET_MASK 0xFFFFU
/* TERRCNT: Transmit error counter (TEC). Access ro.
 * Contradictions of the manual: txbo_threshold.
 */
#define DSPIC33_CANFD_TREC_L_TERRCNT_Pos 8U
#define DSPIC33_CANFD_TREC_L_TERRCNT_Msk 0xFF00U
#define DSPIC33_CANFD_TREC_L_TERRCNT_Width 8U
#define DSPIC33_CANFD_TREC_L_TERRCNT_Access "ro"
static inline uint16_t dspic33_canfd_trec_l_terrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_L_TERRCNT_Msk) >> DSPIC33_CANFD_TREC_L_TERRCNT_Pos);
}
/* RERRCNT: Receive error counter (REC). Access ro. */
#define DSPIC33_CANFD_TREC_L_RERRCNT_Pos 0U
#define DSPIC33_CANFD_TREC_L_RERRCNT_Msk 0x00FFU
#define DSPIC33_CANFD_TREC_L_RERRCNT_Width 8U
#define DSPIC33_CANFD_TREC_L_RERRCNT_Access "ro"
static inline uint16_t dspic33_canfd_trec_l_rerrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_L_RERRCNT_Msk) >> DSPIC33_CANFD_TREC_L_RERRCNT_Pos);
}

/* TRECH: CAN Transmit/Receive Error Count Register High.
 * Error states. Reset on leaving Configuration mode and on recovery from bus off.
 * Contradictions of the manual: trec_reset_txbo.
 * Register 3-45; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_TREC_H_OFFSET 0x036U
#define DSPIC33_CANFD_TREC_H_RESET 0x0020U
#define DSPIC33_CANFD_TREC_H_RESET_MASK 0xFFFFU
/* TXBO: The transmitter is in bus off (TEC above 255) and CxTX stays high. Also set in Configuration mode, in
 * which the module is off the bus. Access ro.
 * Contradictions of the manual: trec_reset_txbo, txbo_threshold.
 */
#define DSPIC33_CANFD_TREC_H_TXBO_Pos 5U
#define DSPIC33_CANFD_TREC_H_TXBO_Msk 0x0020U
#define DSPIC33_CANFD_TREC_H_TXBO_Width 1U
#define DSPIC33_CANFD_TREC_H_TXBO_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_txbo_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_TXBO_Msk) >> DSPIC33_CANFD_TREC_H_TXBO_Pos);
}
/* TXBP: The transmitter is error passive (TEC above 127). Access ro. */
#define DSPIC33_CANFD_TREC_H_TXBP_Pos 4U
#define DSPIC33_CANFD_TREC_H_TXBP_Msk 0x0010U
#define DSPIC33_CANFD_TREC_H_TXBP_Width 1U
#define DSPIC33_CANFD_TREC_H_TXBP_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_txbp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_TXBP_Msk) >> DSPIC33_CANFD_TREC_H_TXBP_Pos);
}
/* RXBP: The receiver is error passive (REC above 127). Access ro. */
#define DSPIC33_CANFD_TREC_H_RXBP_Pos 3U
#define DSPIC33_CANFD_TREC_H_RXBP_Msk 0x0008U
#define DSPIC33_CANFD_TREC_H_RXBP_Width 1U
#define DSPIC33_CANFD_TREC_H_RXBP_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_rxbp_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_RXBP_Msk) >> DSPIC33_CANFD_TREC_H_RXBP_Pos);
}
/* TXWARN: The transmitter is in the warning range (TEC 96 to 127). Access ro. */
#define DSPIC33_CANFD_TREC_H_TXWARN_Pos 2U
#define DSPIC33_CANFD_TREC_H_TXWARN_Msk 0x0004U
#define DSPIC33_CANFD_TREC_H_TXWARN_Width 1U
#define DSPIC33_CANFD_TREC_H_TXWARN_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_txwarn_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_TXWARN_Msk) >> DSPIC33_CANFD_TREC_H_TXWARN_Pos);
}
/* RXWARN: The receiver is in the warning range (REC 96 to 127). Access ro. */
#define DSPIC33_CANFD_TREC_H_RXWARN_Pos 1U
#define DSPIC33_CANFD_TREC_H_RXWARN_Msk 0x0002U
#define DSPIC33_CANFD_TREC_H_RXWARN_Width 1U
#define DSPIC33_CANFD_TREC_H_RXWARN_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_rxwarn_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_RXWARN_Msk) >> DSPIC33_CANFD_TREC_H_RXWARN_Pos);
}
/* EWARN: The transmitter or the receiver is in the warning range. Access ro. */
#define DSPIC33_CANFD_TREC_H_EWARN_Pos 0U
#define DSPIC33_CANFD_TREC_H_EWARN_Msk 0x0001U
#define DSPIC33_CANFD_TREC_H_EWARN_Width 1U
#define DSPIC33_CANFD_TREC_H_EWARN_Access "ro"
static inline uint16_t dspic33_canfd_trec_h_ewarn_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TREC_H_EWARN_Msk) >> DSPIC33_CANFD_TREC_H_EWARN_Pos);
}

/* BDIAG0L: CAN Bus Diagnostics Register 0 Low.
 * Errors at the nominal bit rate, simply counted and never decremented. Cleared by writing 0, and reset on
 * leaving Configuration mode.
 * Register 3-46; §13.0 p.116; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_BDIAG0_L_OFFSET 0x038U
#define DSPIC33_CANFD_BDIAG0_L_RESET 0x0000U
#define DSPIC33_CANFD_BDIAG0_L_RESET_MASK 0xFFFFU
/* NTERRCNT: Transmit errors at the nominal bit rate. Access rwh. Read and write, but hardware changes it too:
 * writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Pos 8U
#define DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Msk 0xFF00U
#define DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Width 8U
#define DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Access "rwh"
#define DSPIC33_CANFD_BDIAG0_L_NTERRCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Pos) & DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Msk))
static inline uint16_t dspic33_canfd_bdiag0_l_nterrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Msk) >> DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Pos);
}
static inline uint16_t dspic33_canfd_bdiag0_l_nterrcnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG0_L_NTERRCNT_Msk) | DSPIC33_CANFD_BDIAG0_L_NTERRCNT_SET(value));
}
/* NRERRCNT: Receive errors at the nominal bit rate. Access rwh. Read and write, but hardware changes it too:
 * writing back a stale value undoes the hardware.
 * Contradictions of the manual: nrerrcnt_name.
 */
#define DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Pos 0U
#define DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Msk 0x00FFU
#define DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Width 8U
#define DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Access "rwh"
#define DSPIC33_CANFD_BDIAG0_L_NRERRCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Pos) & DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Msk))
static inline uint16_t dspic33_canfd_bdiag0_l_nrerrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Msk) >> DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Pos);
}
static inline uint16_t dspic33_canfd_bdiag0_l_nrerrcnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG0_L_NRERRCNT_Msk) | DSPIC33_CANFD_BDIAG0_L_NRERRCNT_SET(value));
}
/* No read-modify-write: no value written to NTERRCNT, NRERRCNT leaves it alone. Compose the whole value and
 * store it.
 */

/* BDIAG0H: CAN Bus Diagnostics Register 0 High.
 * Errors at the data bit rate, simply counted and never decremented. Cleared by writing 0, and reset on leaving
 * Configuration mode.
 * Register 3-47; §13.0 p.116; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_BDIAG0_H_OFFSET 0x03AU
#define DSPIC33_CANFD_BDIAG0_H_RESET 0x0000U
#define DSPIC33_CANFD_BDIAG0_H_RESET_MASK 0xFFFFU
/* DTERRCNT: Transmit errors at the data bit rate. Access rwh. Read and write, but hardware changes it too:
 * writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Pos 8U
#define DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Msk 0xFF00U
#define DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Width 8U
#define DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Access "rwh"
#define DSPIC33_CANFD_BDIAG0_H_DTERRCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Pos) & DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Msk))
static inline uint16_t dspic33_canfd_bdiag0_h_dterrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Msk) >> DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Pos);
}
static inline uint16_t dspic33_canfd_bdiag0_h_dterrcnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG0_H_DTERRCNT_Msk) | DSPIC33_CANFD_BDIAG0_H_DTERRCNT_SET(value));
}
/* DRERRCNT: Receive errors at the data bit rate. Access rwh. Read and write, but hardware changes it too:
 * writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Pos 0U
#define DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Msk 0x00FFU
#define DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Width 8U
#define DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Access "rwh"
#define DSPIC33_CANFD_BDIAG0_H_DRERRCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Pos) & DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Msk))
static inline uint16_t dspic33_canfd_bdiag0_h_drerrcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Msk) >> DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Pos);
}
static inline uint16_t dspic33_canfd_bdiag0_h_drerrcnt_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 255U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG0_H_DRERRCNT_Msk) | DSPIC33_CANFD_BDIAG0_H_DRERRCNT_SET(value));
}
/* No read-modify-write: no value written to DTERRCNT, DRERRCNT leaves it alone. Compose the whole value and
 * store it.
 */

/* BDIAG1L: CAN Bus Diagnostics Register 1 Low.
 * Number of messages without error since the counter was last cleared. Cleared by writing 0, and reset on
 * leaving Configuration mode.
 * Register 3-48; §13.0 p.116; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_BDIAG1_L_OFFSET 0x03CU
#define DSPIC33_CANFD_BDIAG1_L_RESET 0x0000U
#define DSPIC33_CANFD_BDIAG1_L_RESET_MASK 0xFFFFU
/* EFMSGCNT: Error-free message counter. Access rwh. Read and write, but hardware changes it too: writing back a
 * stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Pos 0U
#define DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Msk 0xFFFFU
#define DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Width 16U
#define DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Pos) & DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Msk))
static inline uint16_t dspic33_canfd_bdiag1_l_efmsgcnt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Msk) >> DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_l_efmsgcnt_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_Msk) | DSPIC33_CANFD_BDIAG1_L_EFMSGCNT_SET(value));
}
/* No read-modify-write: no value written to EFMSGCNT leaves it alone. Compose the whole value and store it. */

/* BDIAG1H: CAN Bus Diagnostics Register 1 High.
 * Kinds of error seen since the register was last cleared. Cleared by writing 0, and reset on leaving
 * Configuration mode.
 * Register 3-49; §13.0 p.116; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_BDIAG1_H_OFFSET 0x03EU
#define DSPIC33_CANFD_BDIAG1_H_RESET 0x0000U
#define DSPIC33_CANFD_BDIAG1_H_RESET_MASK 0xFFFFU
/* DLCMM: DLC mismatch: a message to be sent or received had a DLC larger than the payload size of the FIFO.
 * Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 * Register 3-49; §6.12; §9.4
 */
#define DSPIC33_CANFD_BDIAG1_H_DLCMM_Pos 15U
#define DSPIC33_CANFD_BDIAG1_H_DLCMM_Msk 0x8000U
#define DSPIC33_CANFD_BDIAG1_H_DLCMM_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DLCMM_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DLCMM_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DLCMM_Pos) & DSPIC33_CANFD_BDIAG1_H_DLCMM_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dlcmm_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DLCMM_Msk) >> DSPIC33_CANFD_BDIAG1_H_DLCMM_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dlcmm_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DLCMM_Msk) | DSPIC33_CANFD_BDIAG1_H_DLCMM_SET(value));
}
/* ESI: The ESI flag of a received CAN FD message was set. Access rwh. Read and write, but hardware changes it
 * too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_ESI_Pos 14U
#define DSPIC33_CANFD_BDIAG1_H_ESI_Msk 0x4000U
#define DSPIC33_CANFD_BDIAG1_H_ESI_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_ESI_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_ESI_Pos) & DSPIC33_CANFD_BDIAG1_H_ESI_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_ESI_Msk) >> DSPIC33_CANFD_BDIAG1_H_ESI_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_ESI_Msk) | DSPIC33_CANFD_BDIAG1_H_ESI_SET(value));
}
/* DCRCERR: CRC error at the data bit rate. Access rwh. Read and write, but hardware changes it too: writing back
 * a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_DCRCERR_Pos 13U
#define DSPIC33_CANFD_BDIAG1_H_DCRCERR_Msk 0x2000U
#define DSPIC33_CANFD_BDIAG1_H_DCRCERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DCRCERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DCRCERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DCRCERR_Pos) & DSPIC33_CANFD_BDIAG1_H_DCRCERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dcrcerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DCRCERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_DCRCERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dcrcerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DCRCERR_Msk) | DSPIC33_CANFD_BDIAG1_H_DCRCERR_SET(value));
}
/* DSTUFERR: Stuff error at the data bit rate. Access rwh. Read and write, but hardware changes it too: writing
 * back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Pos 12U
#define DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Msk 0x1000U
#define DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DSTUFERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Pos) & DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dstuferr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dstuferr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DSTUFERR_Msk) | DSPIC33_CANFD_BDIAG1_H_DSTUFERR_SET(value));
}
/* DFORMERR: Form error at the data bit rate. Access rwh. Read and write, but hardware changes it too: writing
 * back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_DFORMERR_Pos 11U
#define DSPIC33_CANFD_BDIAG1_H_DFORMERR_Msk 0x0800U
#define DSPIC33_CANFD_BDIAG1_H_DFORMERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DFORMERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DFORMERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DFORMERR_Pos) & DSPIC33_CANFD_BDIAG1_H_DFORMERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dformerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DFORMERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_DFORMERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dformerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DFORMERR_Msk) | DSPIC33_CANFD_BDIAG1_H_DFORMERR_SET(value));
}
/* DBIT1ERR: Recessive bit read back dominant at the data bit rate. Access rwh. Read and write, but hardware
 * changes it too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Pos 9U
#define DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Msk 0x0200U
#define DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Pos) & DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dbit1err_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dbit1err_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_Msk) | DSPIC33_CANFD_BDIAG1_H_DBIT1ERR_SET(value));
}
/* DBIT0ERR: Dominant bit read back recessive at the data bit rate. Access rwh. Read and write, but hardware
 * changes it too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Pos 8U
#define DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Msk 0x0100U
#define DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Pos) & DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_dbit0err_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_dbit0err_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_Msk) | DSPIC33_CANFD_BDIAG1_H_DBIT0ERR_SET(value));
}
/* TXBOERR: The module went to bus off and recovered by itself. Set when it leaves bus off. Access rwh. Read and
 * write, but hardware changes it too: writing back a stale value undoes the hardware.
 * Register 3-49; §13.1 p.117
 */
#define DSPIC33_CANFD_BDIAG1_H_TXBOERR_Pos 7U
#define DSPIC33_CANFD_BDIAG1_H_TXBOERR_Msk 0x0080U
#define DSPIC33_CANFD_BDIAG1_H_TXBOERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_TXBOERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_TXBOERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_TXBOERR_Pos) & DSPIC33_CANFD_BDIAG1_H_TXBOERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_txboerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_TXBOERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_TXBOERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_txboerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_TXBOERR_Msk) | DSPIC33_CANFD_BDIAG1_H_TXBOERR_SET(value));
}
/* NCRCERR: CRC error at the nominal bit rate: the CRC received differs from the one computed over the frame.
 * Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NCRCERR_Pos 5U
#define DSPIC33_CANFD_BDIAG1_H_NCRCERR_Msk 0x0020U
#define DSPIC33_CANFD_BDIAG1_H_NCRCERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NCRCERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NCRCERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NCRCERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NCRCERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_ncrcerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NCRCERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NCRCERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_ncrcerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NCRCERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NCRCERR_SET(value));
}
/* NSTUFERR: Stuff error at the nominal bit rate: a received frame had six or more equal bits in a row where bit
 * stuffing rules them out. Access rwh. Read and write, but hardware changes it too: writing back a stale value
 * undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Pos 4U
#define DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Msk 0x0010U
#define DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NSTUFERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_nstuferr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_nstuferr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NSTUFERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NSTUFERR_SET(value));
}
/* NFORMERR: Form error at the nominal bit rate: a field of fixed form in a received frame held other bits than
 * it must. Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the
 * hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NFORMERR_Pos 3U
#define DSPIC33_CANFD_BDIAG1_H_NFORMERR_Msk 0x0008U
#define DSPIC33_CANFD_BDIAG1_H_NFORMERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NFORMERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NFORMERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NFORMERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NFORMERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_nformerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NFORMERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NFORMERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_nformerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NFORMERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NFORMERR_SET(value));
}
/* NACKERR: No node acknowledged a transmitted message. Access rwh. Read and write, but hardware changes it too:
 * writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NACKERR_Pos 2U
#define DSPIC33_CANFD_BDIAG1_H_NACKERR_Msk 0x0004U
#define DSPIC33_CANFD_BDIAG1_H_NACKERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NACKERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NACKERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NACKERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NACKERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_nackerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NACKERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NACKERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_nackerr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NACKERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NACKERR_SET(value));
}
/* NBIT1ERR: Outside the arbitration field a recessive bit was sent but the bus was dominant. Access rwh. Read
 * and write, but hardware changes it too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Pos 1U
#define DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Msk 0x0002U
#define DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_nbit1err_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_nbit1err_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NBIT1ERR_SET(value));
}
/* NBIT0ERR: A dominant bit (frame, acknowledge, active error flag or overload flag) was sent but the bus was
 * recessive. During bus off recovery it is set each time 11 recessive bits have been seen. Access rwh. Read and
 * write, but hardware changes it too: writing back a stale value undoes the hardware.
 */
#define DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Pos 0U
#define DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Msk 0x0001U
#define DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Width 1U
#define DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Access "rwh"
#define DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Pos) & DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Msk))
static inline uint16_t dspic33_canfd_bdiag1_h_nbit0err_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Msk) >> DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Pos);
}
static inline uint16_t dspic33_canfd_bdiag1_h_nbit0err_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_Msk) | DSPIC33_CANFD_BDIAG1_H_NBIT0ERR_SET(value));
}
/* No read-modify-write: no value written to DLCMM, ESI, DCRCERR, DSTUFERR, DFORMERR, DBIT1ERR, DBIT0ERR,
 * TXBOERR, NCRCERR, NSTUFERR, NFORMERR, NACKERR, NBIT1ERR, NBIT0ERR leaves it alone. Compose the whole value and
 * store it.
 */

/* FLTCON: CAN Filter Control Registers.
 * Enable and target FIFO of two filters per register. Filters are tried from 0 up; the first match whose FIFO
 * has room stores the message.
 * Hazard: Order for changing a filter: clear FLTEN, write object and mask, write FnBP, set FLTEN.
 * Hazard: On devices with fewer FIFOs than 31 these registers stand at a lower address.
 * Contradictions of the manual: register_headings.
 * Register 3-50; Register 3-51; §8.1; §8.2; external: mcp251xfd (offset); external: mcp251xfd_api (offset with
 * fewer FIFOs)
 */
#define DSPIC33_CANFD_FLT_CON_OFFSET 0x1D0U
#define DSPIC33_CANFD_FLT_CON_COUNT 16U
#define DSPIC33_CANFD_FLT_CON_STRIDE 0x002U
#define DSPIC33_CANFD_FLT_CON_FIRST 0U
#define DSPIC33_CANFD_FLT_CON_RESET 0x0000U
#define DSPIC33_CANFD_FLT_CON_RESET_MASK 0xFFFFU
/* FLTENn: Enables filter n to accept messages. Access rw. Lane 0 is number 0 in the first register. */
#define DSPIC33_CANFD_FLT_CON_FLTEN_Pos(lane) (7U + 8U * (lane))
#define DSPIC33_CANFD_FLT_CON_FLTEN_Msk(lane) ((uint16_t)(0x0080U << (8U * (lane))))
#define DSPIC33_CANFD_FLT_CON_FLTEN_Lanes 2U
#define DSPIC33_CANFD_FLT_CON_FLTEN_Width 1U
#define DSPIC33_CANFD_FLT_CON_FLTEN_Access "rw"
#define DSPIC33_CANFD_FLT_CON_FLTEN_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_CON_FLTEN_Pos(lane)) & DSPIC33_CANFD_FLT_CON_FLTEN_Msk(lane)))
static inline uint16_t dspic33_canfd_flt_con_flten_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_CON_FLTEN_Msk(lane)) >> DSPIC33_CANFD_FLT_CON_FLTEN_Pos(lane));
}
static inline uint16_t dspic33_canfd_flt_con_flten_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(lane < 2U);
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_CON_FLTEN_Msk(lane)) | DSPIC33_CANFD_FLT_CON_FLTEN_SET(lane, value));
}
/* FnBP: FIFO that stores the messages filter n accepts. If it is a transmit FIFO with RTREN set, a matching
 * remote frame requests its transmission; a message for a transmit FIFO with RTREN clear is discarded. Access
 * rw. Lane 0 is number 0 in the first register.
 */
#define DSPIC33_CANFD_FLT_CON_FBP_Pos(lane) (0U + 8U * (lane))
#define DSPIC33_CANFD_FLT_CON_FBP_Msk(lane) ((uint16_t)(0x001FU << (8U * (lane))))
#define DSPIC33_CANFD_FLT_CON_FBP_Lanes 2U
#define DSPIC33_CANFD_FLT_CON_FBP_Width 5U
#define DSPIC33_CANFD_FLT_CON_FBP_Access "rw"
#define DSPIC33_CANFD_FLT_CON_FBP_SET(lane, value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_CON_FBP_Pos(lane)) & DSPIC33_CANFD_FLT_CON_FBP_Msk(lane)))
static inline uint16_t dspic33_canfd_flt_con_fbp_get(uint16_t reg, unsigned int lane)
{
    DSPIC33_CANFD_ASSERT(lane < 2U);
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_CON_FBP_Msk(lane)) >> DSPIC33_CANFD_FLT_CON_FBP_Pos(lane));
}
static inline uint16_t dspic33_canfd_flt_con_fbp_set(uint16_t reg, unsigned int lane, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(lane < 2U);
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_CON_FBP_Msk(lane)) | DSPIC33_CANFD_FLT_CON_FBP_SET(lane, value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_flt_con(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 16U);
    return &regs->FLTCON[n];
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_flt_con_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n < 16U);
    uint16_t value = regs->FLTCON[n];
    regs->FLTCON[n] = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* CANCLKCON: CAN Clock Control Register.
 * CAN clock generator of the device, common to all modules.
 * Hazard: The source may run at 640 MHz at most, the divided clock at 80 MHz at most.
 * Hazard: Do not change the divider while a CAN module operates.
 * Belongs to the chip around the controller: its address is not known here.
 * Contradictions of the manual: example_6_1_clock.
 * Register 5-1
 */
#define DSPIC33_CANFD_CANCLKCON_RESET 0x0000U
#define DSPIC33_CANFD_CANCLKCON_RESET_MASK 0xFFFFU
/* CANCLKEN: Enables the CAN clock generator. Access rw. */
#define DSPIC33_CANFD_CANCLKCON_CANCLKEN_Pos 15U
#define DSPIC33_CANFD_CANCLKCON_CANCLKEN_Msk 0x8000U
#define DSPIC33_CANFD_CANCLKCON_CANCLKEN_Width 1U
#define DSPIC33_CANFD_CANCLKCON_CANCLKEN_Access "rw"
#define DSPIC33_CANFD_CANCLKCON_CANCLKEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CANCLKCON_CANCLKEN_Pos) & DSPIC33_CANFD_CANCLKCON_CANCLKEN_Msk))
static inline uint16_t dspic33_canfd_canclkcon_canclken_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CANCLKCON_CANCLKEN_Msk) >> DSPIC33_CANFD_CANCLKCON_CANCLKEN_Pos);
}
static inline uint16_t dspic33_canfd_canclkcon_canclken_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CANCLKCON_CANCLKEN_Msk) | DSPIC33_CANFD_CANCLKCON_CANCLKEN_SET(value));
}
/* CANCLKSEL: Source of the CAN clock generator, 640 MHz at most. The VCO outputs can be used whatever VCODIV and
 * AVCODIV say. Access rw.
 */
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Pos 8U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Msk 0x0F00U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Width 4U
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Access "rw"
#define DSPIC33_CANFD_CANCLKCON_CANCLKSEL_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Pos) & DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Msk))
static inline uint16_t dspic33_canfd_canclkcon_canclksel_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Msk) >> DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Pos);
}
static inline uint16_t dspic33_canfd_canclkcon_canclksel_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CANCLKCON_CANCLKSEL_Msk) | DSPIC33_CANFD_CANCLKCON_CANCLKSEL_SET(value));
}
/* CANCLKDIV: Divider of the CAN clock generator, 1 to 128. The result must not exceed 80 MHz. Access rw. Means
 * value + 1 divisor.
 */
#define DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Pos 0U
#define DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Msk 0x007FU
#define DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Width 7U
#define DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Access "rw"
#define DSPIC33_CANFD_CANCLKCON_CANCLKDIV_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Pos) & DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Msk))
static inline uint16_t dspic33_canfd_canclkcon_canclkdiv_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Msk) >> DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Pos);
}
static inline uint16_t dspic33_canfd_canclkcon_canclkdiv_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_CANCLKCON_CANCLKDIV_Msk) | DSPIC33_CANFD_CANCLKCON_CANCLKDIV_SET(value));
}

/* FIFOCONnL: CAN FIFO Control Register Low.
 * Direction, requests, timestamping and interrupt enables of the FIFO.
 * Hazard: Writing TXREQ 0 while it is 1 requests an abort. A write meant for another bit, such as UINC, has to
 * carry TXREQ 1 while the FIFO is transmitting.
 * Hazard: Writing back a TXREQ that hardware has cleared meanwhile is a new request.
 * Hazard: When appending while the FIFO is transmitting, set UINC and TXREQ in the same write; TXREQ is cleared
 * when the FIFO runs empty.
 * Hazard: Before FRESET of a transmit FIFO no transmission may be pending; before FRESET of a receive FIFO no
 * enabled filter may point to it. Afterwards wait until FRESET reads 0. In Configuration mode it stays 1.
 * Hazard: Writing into a full FIFO can damage a message that is being sent; check TFNRFNIF first.
 * Contradictions of the manual: register_headings.
 * Register 3-32; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_CON_L_OFFSET 0x05CU
#define DSPIC33_CANFD_FIFO_CON_L_COUNT 31U
#define DSPIC33_CANFD_FIFO_CON_L_STRIDE 0x00CU
#define DSPIC33_CANFD_FIFO_CON_L_FIRST 1U
#define DSPIC33_CANFD_FIFO_CON_L_RESET 0x0400U
#define DSPIC33_CANFD_FIFO_CON_L_RESET_MASK 0xFFFFU
/* FRESET: Writing 1 resets head, tail and status register of the FIFO, hardware clears it when done; writing 0
 * has no effect. Held at 1 in Configuration mode. Access w1s. A request: writing 1 makes it, writing 0 does
 * nothing, hardware clears it.
 * Register 3-32; §6.14; §9.3; §4.2
 */
#define DSPIC33_CANFD_FIFO_CON_L_FRESET_Pos 10U
#define DSPIC33_CANFD_FIFO_CON_L_FRESET_Msk 0x0400U
#define DSPIC33_CANFD_FIFO_CON_L_FRESET_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_FRESET_Access "w1s"
static inline uint16_t dspic33_canfd_fifo_con_l_freset_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_FRESET_Msk) >> DSPIC33_CANFD_FIFO_CON_L_FRESET_Pos);
}
/* TXREQ: Writing 1 requests transmission; hardware clears it when all messages in the FIFO are sent, or when
 * attempts are exhausted, aborted or stopped by a DLC mismatch. Writing 0 while it is 1 requests an abort; it
 * then stays 1 until aborted or sent. No effect on a receive FIFO. Access rwhc. A request that can be withdrawn:
 * 1 requests, 0 aborts, hardware clears it.
 * Contradictions of the manual: abort_register, example_6_1_append.
 * Register 3-32; §6.4; §6.10
 */
#define DSPIC33_CANFD_FIFO_CON_L_TXREQ_Pos 9U
#define DSPIC33_CANFD_FIFO_CON_L_TXREQ_Msk 0x0200U
#define DSPIC33_CANFD_FIFO_CON_L_TXREQ_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TXREQ_Access "rwhc"
#define DSPIC33_CANFD_FIFO_CON_L_TXREQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TXREQ_Pos) & DSPIC33_CANFD_FIFO_CON_L_TXREQ_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_txreq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TXREQ_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TXREQ_Pos);
}
/* UINC: Writing 1 advances the FIFO by one message: the head of a transmit FIFO after loading, the tail of a
 * receive FIFO after reading. The user address follows. Access w1s. A request: writing 1 makes it, writing 0
 * does nothing, hardware clears it.
 * Contradictions of the manual: example_6_1_append.
 */
#define DSPIC33_CANFD_FIFO_CON_L_UINC_Pos 8U
#define DSPIC33_CANFD_FIFO_CON_L_UINC_Msk 0x0100U
#define DSPIC33_CANFD_FIFO_CON_L_UINC_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_UINC_Access "w1s"
static inline uint16_t dspic33_canfd_fifo_con_l_uinc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_UINC_Msk) >> DSPIC33_CANFD_FIFO_CON_L_UINC_Pos);
}
/* TXEN: Direction of the FIFO. Access rw:config. A write has an effect only if config (CONH.OPMOD ==
 * configuration).
 * Contradictions of the manual: protected_fields.
 * Register 3-32; §4.2 (when)
 */
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_Pos 7U
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_Msk 0x0080U
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_Access "rw:config"
#define DSPIC33_CANFD_FIFO_CON_L_TXEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TXEN_Pos) & DSPIC33_CANFD_FIFO_CON_L_TXEN_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_txen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TXEN_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TXEN_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_txen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_TXEN_Msk) | DSPIC33_CANFD_FIFO_CON_L_TXEN_SET(value));
}
/* RTREN: Auto-remote transmit: a remote frame accepted by a filter that points to this transmit FIFO sets TXREQ
 * (1) or leaves it alone (0). Access rw.
 * Register 3-32; §6.11
 */
#define DSPIC33_CANFD_FIFO_CON_L_RTREN_Pos 6U
#define DSPIC33_CANFD_FIFO_CON_L_RTREN_Msk 0x0040U
#define DSPIC33_CANFD_FIFO_CON_L_RTREN_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_RTREN_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_RTREN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_RTREN_Pos) & DSPIC33_CANFD_FIFO_CON_L_RTREN_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_rtren_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_RTREN_Msk) >> DSPIC33_CANFD_FIFO_CON_L_RTREN_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_rtren_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_RTREN_Msk) | DSPIC33_CANFD_FIFO_CON_L_RTREN_SET(value));
}
/* RXTSEN: Stores a timestamp in received message objects, which makes them 4 bytes larger. No effect on the size
 * of a transmit FIFO. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration).
 * Register 3-32; §5.4.5
 */
#define DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Pos 5U
#define DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Msk 0x0020U
#define DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Access "rw:config"
#define DSPIC33_CANFD_FIFO_CON_L_RXTSEN_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Pos) & DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_rxtsen_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Msk) >> DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_rxtsen_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_RXTSEN_Msk) | DSPIC33_CANFD_FIFO_CON_L_RXTSEN_SET(value));
}
/* TXATIE: Enables the attempts exhausted interrupt. Access rw. */
#define DSPIC33_CANFD_FIFO_CON_L_TXATIE_Pos 4U
#define DSPIC33_CANFD_FIFO_CON_L_TXATIE_Msk 0x0010U
#define DSPIC33_CANFD_FIFO_CON_L_TXATIE_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TXATIE_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_TXATIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TXATIE_Pos) & DSPIC33_CANFD_FIFO_CON_L_TXATIE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_txatie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TXATIE_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TXATIE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_txatie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_TXATIE_Msk) | DSPIC33_CANFD_FIFO_CON_L_TXATIE_SET(value));
}
/* RXOVIE: Enables the overflow interrupt. Access rw. */
#define DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Pos 3U
#define DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Msk 0x0008U
#define DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_RXOVIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Pos) & DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_rxovie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Msk) >> DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_rxovie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_RXOVIE_Msk) | DSPIC33_CANFD_FIFO_CON_L_RXOVIE_SET(value));
}
/* TFERFFIE: Enables the interrupt for an empty transmit FIFO or a full receive FIFO. Access rw. */
#define DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Pos 2U
#define DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Msk 0x0004U
#define DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Pos) & DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_tferffie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_tferffie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_Msk) | DSPIC33_CANFD_FIFO_CON_L_TFERFFIE_SET(value));
}
/* TFHRFHIE: Enables the interrupt for a half empty transmit FIFO or a half full receive FIFO. Access rw. */
#define DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Pos 1U
#define DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Msk 0x0002U
#define DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Pos) & DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_tfhrfhie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_tfhrfhie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_Msk) | DSPIC33_CANFD_FIFO_CON_L_TFHRFHIE_SET(value));
}
/* TFNRFNIE: Enables the interrupt for a transmit FIFO that is not full or a receive FIFO that is not empty.
 * Access rw.
 */
#define DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Pos 0U
#define DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Msk 0x0001U
#define DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Width 1U
#define DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Pos) & DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_l_tfnrfnie_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Msk) >> DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_l_tfnrfnie_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_Msk) | DSPIC33_CANFD_FIFO_CON_L_TFNRFNIE_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_fifo_con_l(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    return &regs->FIFO[n - 1U].FIFOCONL;
}
/* No read-modify-write: no value written to TXREQ leaves it alone. Compose the whole value and store it. */

/* FIFOCONnH: CAN FIFO Control Register High.
 * Size, retransmission attempts and priority of the FIFO.
 * Register 3-33; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_CON_H_OFFSET 0x05EU
#define DSPIC33_CANFD_FIFO_CON_H_COUNT 31U
#define DSPIC33_CANFD_FIFO_CON_H_STRIDE 0x00CU
#define DSPIC33_CANFD_FIFO_CON_H_FIRST 1U
#define DSPIC33_CANFD_FIFO_CON_H_RESET 0x0060U
#define DSPIC33_CANFD_FIFO_CON_H_RESET_MASK 0xFFFFU
/* PLSIZE: Payload size of every message object in the FIFO. Access rw:config. A write has an effect only if
 * config (CONH.OPMOD == configuration).
 */
#define DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Pos 13U
#define DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Msk 0xE000U
#define DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Width 3U
#define DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Access "rw:config"
#define DSPIC33_CANFD_FIFO_CON_H_PLSIZE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Pos) & DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_h_plsize_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Msk) >> DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_h_plsize_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 7U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_H_PLSIZE_Msk) | DSPIC33_CANFD_FIFO_CON_H_PLSIZE_SET(value));
}
/* FSIZE: Depth of the FIFO, 1 to 32 messages. A FIFO below the highest one in use takes RAM even if it is not
 * used. Access rw:config. A write has an effect only if config (CONH.OPMOD == configuration). Means value + 1
 * messages.
 */
#define DSPIC33_CANFD_FIFO_CON_H_FSIZE_Pos 8U
#define DSPIC33_CANFD_FIFO_CON_H_FSIZE_Msk 0x1F00U
#define DSPIC33_CANFD_FIFO_CON_H_FSIZE_Width 5U
#define DSPIC33_CANFD_FIFO_CON_H_FSIZE_Access "rw:config"
#define DSPIC33_CANFD_FIFO_CON_H_FSIZE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_H_FSIZE_Pos) & DSPIC33_CANFD_FIFO_CON_H_FSIZE_Msk))
static inline uint16_t dspic33_canfd_fifo_con_h_fsize_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_H_FSIZE_Msk) >> DSPIC33_CANFD_FIFO_CON_H_FSIZE_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_h_fsize_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_H_FSIZE_Msk) | DSPIC33_CANFD_FIFO_CON_H_FSIZE_SET(value));
}
/* TXAT: Retransmission attempts; used only while CONH.RTXAT is set. Access rw. */
#define DSPIC33_CANFD_FIFO_CON_H_TXAT_Pos 5U
#define DSPIC33_CANFD_FIFO_CON_H_TXAT_Msk 0x0060U
#define DSPIC33_CANFD_FIFO_CON_H_TXAT_Width 2U
#define DSPIC33_CANFD_FIFO_CON_H_TXAT_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_H_TXAT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_H_TXAT_Pos) & DSPIC33_CANFD_FIFO_CON_H_TXAT_Msk))
static inline uint16_t dspic33_canfd_fifo_con_h_txat_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_H_TXAT_Msk) >> DSPIC33_CANFD_FIFO_CON_H_TXAT_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_h_txat_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 3U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_H_TXAT_Msk) | DSPIC33_CANFD_FIFO_CON_H_TXAT_SET(value));
}
/* TXPRI: Transmit priority, 0 lowest to 31 highest. At equal priority the queue goes first, then the FIFO with
 * the highest number. Priorities are compared anew after every message. Access rw.
 * Register 3-33; §6.7
 */
#define DSPIC33_CANFD_FIFO_CON_H_TXPRI_Pos 0U
#define DSPIC33_CANFD_FIFO_CON_H_TXPRI_Msk 0x001FU
#define DSPIC33_CANFD_FIFO_CON_H_TXPRI_Width 5U
#define DSPIC33_CANFD_FIFO_CON_H_TXPRI_Access "rw"
#define DSPIC33_CANFD_FIFO_CON_H_TXPRI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FIFO_CON_H_TXPRI_Pos) & DSPIC33_CANFD_FIFO_CON_H_TXPRI_Msk))
static inline uint16_t dspic33_canfd_fifo_con_h_txpri_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_CON_H_TXPRI_Msk) >> DSPIC33_CANFD_FIFO_CON_H_TXPRI_Pos);
}
static inline uint16_t dspic33_canfd_fifo_con_h_txpri_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FIFO_CON_H_TXPRI_Msk) | DSPIC33_CANFD_FIFO_CON_H_TXPRI_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_fifo_con_h(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    return &regs->FIFO[n - 1U].FIFOCONH;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_fifo_con_h_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    uint16_t value = regs->FIFO[n - 1U].FIFOCONH;
    regs->FIFO[n - 1U].FIFOCONH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FIFOSTAn: CAN FIFO Status Register.
 * Status of the FIFO. Most flags have one meaning for a transmit FIFO and the opposite one for a receive FIFO.
 * Hazard: Any read clears TXABT. Take everything that is needed from one read.
 * Hazard: Clear TXATIF or RXOVIF with a word that has 0 in its place and 1 in the other; do not write back what
 * was read.
 * Hazard: As soon as the FIFO is configured for transmission it reads TFERFFIF, TFHRFHIF and TFNRFNIF set,
 * because it is empty.
 * Register 3-34; §10.1; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_STA_OFFSET 0x060U
#define DSPIC33_CANFD_FIFO_STA_COUNT 31U
#define DSPIC33_CANFD_FIFO_STA_STRIDE 0x00CU
#define DSPIC33_CANFD_FIFO_STA_FIRST 1U
#define DSPIC33_CANFD_FIFO_STA_RESET 0x0000U
#define DSPIC33_CANFD_FIFO_STA_RESET_MASK 0xFFFFU
/* FIFOCI: Index, counted from 0, of the message that will be sent next (transmit) or of the object that will
 * store the next message (receive). An abort leaves it unchanged. Access ro.
 * Contradictions of the manual: fifoci_name.
 */
#define DSPIC33_CANFD_FIFO_STA_FIFOCI_Pos 8U
#define DSPIC33_CANFD_FIFO_STA_FIFOCI_Msk 0x1F00U
#define DSPIC33_CANFD_FIFO_STA_FIFOCI_Width 5U
#define DSPIC33_CANFD_FIFO_STA_FIFOCI_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_fifoci_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_FIFOCI_Msk) >> DSPIC33_CANFD_FIFO_STA_FIFOCI_Pos);
}
/* TXABT: The message was aborted (1) or completed (0). Reset by any read of this register and when the FIFO is
 * reset. Access ro+rc. A read of the register clears it.
 * Contradictions of the manual: txabt_reset.
 */
#define DSPIC33_CANFD_FIFO_STA_TXABT_Pos 7U
#define DSPIC33_CANFD_FIFO_STA_TXABT_Msk 0x0080U
#define DSPIC33_CANFD_FIFO_STA_TXABT_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TXABT_Access "ro+rc"
static inline uint16_t dspic33_canfd_fifo_sta_txabt_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TXABT_Msk) >> DSPIC33_CANFD_FIFO_STA_TXABT_Pos);
}
/* TXLARB: Another node won the arbitration against the message. Renewed with every message that completes or
 * aborts, and by a reset of the FIFO. Access ro.
 */
#define DSPIC33_CANFD_FIFO_STA_TXLARB_Pos 6U
#define DSPIC33_CANFD_FIFO_STA_TXLARB_Msk 0x0040U
#define DSPIC33_CANFD_FIFO_STA_TXLARB_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TXLARB_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_txlarb_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TXLARB_Msk) >> DSPIC33_CANFD_FIFO_STA_TXLARB_Pos);
}
/* TXERR: Sending the message met a bus error. Renewed with every message that completes or aborts, and by a
 * reset of the FIFO. Access ro.
 */
#define DSPIC33_CANFD_FIFO_STA_TXERR_Pos 5U
#define DSPIC33_CANFD_FIFO_STA_TXERR_Msk 0x0020U
#define DSPIC33_CANFD_FIFO_STA_TXERR_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TXERR_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_txerr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TXERR_Msk) >> DSPIC33_CANFD_FIFO_STA_TXERR_Pos);
}
/* TXATIF: The transmit attempts are exhausted. Cleared by the application. Reads 0 on a receive FIFO. Access
 * w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: txatif_cause.
 * Register 3-34; §12.1.5
 */
#define DSPIC33_CANFD_FIFO_STA_TXATIF_Pos 4U
#define DSPIC33_CANFD_FIFO_STA_TXATIF_Msk 0x0010U
#define DSPIC33_CANFD_FIFO_STA_TXATIF_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TXATIF_Access "w0c"
static inline uint16_t dspic33_canfd_fifo_sta_txatif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TXATIF_Msk) >> DSPIC33_CANFD_FIFO_STA_TXATIF_Pos);
}
/* RXOVIF: A message for this receive FIFO was lost because it was full, or a remote frame asked an empty
 * transmit FIFO for a message. Cleared by the application. Access w0c. A flag: writing 0 clears it, writing 1
 * does nothing.
 * Contradictions of the manual: rxovif_transmit_fifo, overflow_moment.
 * Register 3-34; §12.1.4; §6.11
 */
#define DSPIC33_CANFD_FIFO_STA_RXOVIF_Pos 3U
#define DSPIC33_CANFD_FIFO_STA_RXOVIF_Msk 0x0008U
#define DSPIC33_CANFD_FIFO_STA_RXOVIF_Width 1U
#define DSPIC33_CANFD_FIFO_STA_RXOVIF_Access "w0c"
static inline uint16_t dspic33_canfd_fifo_sta_rxovif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_RXOVIF_Msk) >> DSPIC33_CANFD_FIFO_STA_RXOVIF_Pos);
}
/* TFERFFIF: Transmit FIFO is empty, or receive FIFO is full. Access ro. */
#define DSPIC33_CANFD_FIFO_STA_TFERFFIF_Pos 2U
#define DSPIC33_CANFD_FIFO_STA_TFERFFIF_Msk 0x0004U
#define DSPIC33_CANFD_FIFO_STA_TFERFFIF_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TFERFFIF_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_tferffif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TFERFFIF_Msk) >> DSPIC33_CANFD_FIFO_STA_TFERFFIF_Pos);
}
/* TFHRFHIF: Transmit FIFO is at most half full, or receive FIFO is at least half full. Access ro.
 * Contradictions of the manual: transmit_half_flag.
 */
#define DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Pos 1U
#define DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Msk 0x0002U
#define DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_tfhrfhif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Msk) >> DSPIC33_CANFD_FIFO_STA_TFHRFHIF_Pos);
}
/* TFNRFNIF: Transmit FIFO is not full, or receive FIFO holds at least one message. Access ro. */
#define DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Pos 0U
#define DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Msk 0x0001U
#define DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Width 1U
#define DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Access "ro"
static inline uint16_t dspic33_canfd_fifo_sta_tfnrfnif_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Msk) >> DSPIC33_CANFD_FIFO_STA_TFNRFNIF_Pos);
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_fifo_sta(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    return &regs->FIFO[n - 1U].FIFOSTA;
}
/* Clears the given flags and no others: one store, no read. */
static inline void dspic33_canfd_fifo_sta_clear(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t flags)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    regs->FIFO[n - 1U].FIFOSTA = (uint16_t)(0x0018U & (uint16_t)~flags);
}
/* No read-modify-write: the read changes TXABT. Compose the whole value and store it. */

/* FIFOUAnL: CAN FIFO User Address Register Low.
 * Low half of the RAM address of the object to write next (transmit, head) or to read next (receive, tail).
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Contradictions of the manual: figure_10_3_user_address.
 * Register 3-38; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_UA_L_OFFSET 0x064U
#define DSPIC33_CANFD_FIFO_UA_L_COUNT 31U
#define DSPIC33_CANFD_FIFO_UA_L_STRIDE 0x00CU
#define DSPIC33_CANFD_FIFO_UA_L_FIRST 1U
#define DSPIC33_CANFD_FIFO_UA_L_RESET 0x0000U
#define DSPIC33_CANFD_FIFO_UA_L_RESET_MASK 0x0000U
/* FIFOUA[15:0]: Bits 15 to 0 of the user address. Access ro. */
#define DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Pos 0U
#define DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Msk 0xFFFFU
#define DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Width 16U
#define DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Access "ro"
static inline uint16_t dspic33_canfd_fifo_ua_l_fifoua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Msk) >> DSPIC33_CANFD_FIFO_UA_L_FIFOUA_Pos);
}
/* The register with the manual's number n. */
static inline const volatile uint16_t *dspic33_canfd_fifo_ua_l(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    return &regs->FIFO[n - 1U].FIFOUAL;
}

/* FIFOUAnH: CAN FIFO User Address Register High.
 * High half of the RAM address of the object to write next (transmit, head) or to read next (receive, tail).
 * Hazard: Not reliable in Configuration mode; read it after leaving that mode.
 * Contradictions of the manual: figure_10_3_user_address.
 * Register 3-39; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FIFO_UA_H_OFFSET 0x066U
#define DSPIC33_CANFD_FIFO_UA_H_COUNT 31U
#define DSPIC33_CANFD_FIFO_UA_H_STRIDE 0x00CU
#define DSPIC33_CANFD_FIFO_UA_H_FIRST 1U
#define DSPIC33_CANFD_FIFO_UA_H_RESET 0x0000U
#define DSPIC33_CANFD_FIFO_UA_H_RESET_MASK 0x0000U
/* FIFOUA[31:16]: Bits 31 to 16 of the user address. Access ro. */
#define DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Pos 0U
#define DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Msk 0xFFFFU
#define DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Width 16U
#define DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Access "ro"
static inline uint16_t dspic33_canfd_fifo_ua_h_fifoua_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Msk) >> DSPIC33_CANFD_FIFO_UA_H_FIFOUA_Pos);
}
/* The register with the manual's number n. */
static inline const volatile uint16_t *dspic33_canfd_fifo_ua_h(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    return &regs->FIFO[n - 1U].FIFOUAH;
}

/* FLTOBJnL: CAN Filter Object Register Low.
 * Standard identifier and low bits of the extended identifier the filter compares with.
 * Contradictions of the manual: filter_bit_tables.
 * Register 3-52 p.51; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FLT_OBJ_L_OFFSET 0x1F0U
#define DSPIC33_CANFD_FLT_OBJ_L_COUNT 32U
#define DSPIC33_CANFD_FLT_OBJ_L_STRIDE 0x008U
#define DSPIC33_CANFD_FLT_OBJ_L_FIRST 0U
#define DSPIC33_CANFD_FLT_OBJ_L_RESET 0x0000U
#define DSPIC33_CANFD_FLT_OBJ_L_RESET_MASK 0xFFFFU
/* EID[4:0]: Extended identifier bits 4 to 0. With DNCNT above 0 and standard frames they are compared with data
 * bits instead. Access rw:filter_disabled. A write has an effect only if filter_disabled (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: data_filter_bits.
 * Register 3-52 p.51; §8.2.3
 */
#define DSPIC33_CANFD_FLT_OBJ_L_EID_Pos 11U
#define DSPIC33_CANFD_FLT_OBJ_L_EID_Msk 0xF800U
#define DSPIC33_CANFD_FLT_OBJ_L_EID_Width 5U
#define DSPIC33_CANFD_FLT_OBJ_L_EID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_FLT_OBJ_L_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_OBJ_L_EID_Pos) & DSPIC33_CANFD_FLT_OBJ_L_EID_Msk))
static inline uint16_t dspic33_canfd_flt_obj_l_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_OBJ_L_EID_Msk) >> DSPIC33_CANFD_FLT_OBJ_L_EID_Pos);
}
static inline uint16_t dspic33_canfd_flt_obj_l_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_OBJ_L_EID_Msk) | DSPIC33_CANFD_FLT_OBJ_L_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw:filter_disabled. A write has an
 * effect only if filter_disabled (!FLTCON.FLTEN[n]).
 */
#define DSPIC33_CANFD_FLT_OBJ_L_SID_Pos 0U
#define DSPIC33_CANFD_FLT_OBJ_L_SID_Msk 0x07FFU
#define DSPIC33_CANFD_FLT_OBJ_L_SID_Width 11U
#define DSPIC33_CANFD_FLT_OBJ_L_SID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_FLT_OBJ_L_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_OBJ_L_SID_Pos) & DSPIC33_CANFD_FLT_OBJ_L_SID_Msk))
static inline uint16_t dspic33_canfd_flt_obj_l_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_OBJ_L_SID_Msk) >> DSPIC33_CANFD_FLT_OBJ_L_SID_Pos);
}
static inline uint16_t dspic33_canfd_flt_obj_l_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_OBJ_L_SID_Msk) | DSPIC33_CANFD_FLT_OBJ_L_SID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_flt_obj_l(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    return &regs->FLT[n].FLTOBJL;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_flt_obj_l_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    uint16_t value = regs->FLT[n].FLTOBJL;
    regs->FLT[n].FLTOBJL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* FLTOBJnH: CAN Filter Object Register High.
 * Frame type, SID11 and high bits of the extended identifier the filter compares with.
 * Contradictions of the manual: filter_bit_tables.
 * Register 3-53 p.51; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_FLT_OBJ_H_OFFSET 0x1F2U
#define DSPIC33_CANFD_FLT_OBJ_H_COUNT 32U
#define DSPIC33_CANFD_FLT_OBJ_H_STRIDE 0x008U
#define DSPIC33_CANFD_FLT_OBJ_H_FIRST 0U
#define DSPIC33_CANFD_FLT_OBJ_H_RESET 0x0000U
#define DSPIC33_CANFD_FLT_OBJ_H_RESET_MASK 0xFFFFU
/* EXIDE: Frame type the filter accepts; used only if MIDE is set. Access rw:filter_disabled. A write has an
 * effect only if filter_disabled (!FLTCON.FLTEN[n]).
 * Register 3-53 p.51; §8.2.1
 */
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Pos 14U
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Msk 0x4000U
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Width 1U
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Access "rw:filter_disabled"
#define DSPIC33_CANFD_FLT_OBJ_H_EXIDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Pos) & DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Msk))
static inline uint16_t dspic33_canfd_flt_obj_h_exide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Msk) >> DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Pos);
}
static inline uint16_t dspic33_canfd_flt_obj_h_exide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_OBJ_H_EXIDE_Msk) | DSPIC33_CANFD_FLT_OBJ_H_EXIDE_SET(value));
}
/* SID11: Least significant bit of a 12-bit standard identifier; used with SID11EN. Access rw:filter_disabled. A
 * write has an effect only if filter_disabled (!FLTCON.FLTEN[n]).
 * Register 3-53 p.51; §8.2.4
 */
#define DSPIC33_CANFD_FLT_OBJ_H_SID11_Pos 13U
#define DSPIC33_CANFD_FLT_OBJ_H_SID11_Msk 0x2000U
#define DSPIC33_CANFD_FLT_OBJ_H_SID11_Width 1U
#define DSPIC33_CANFD_FLT_OBJ_H_SID11_Access "rw:filter_disabled"
#define DSPIC33_CANFD_FLT_OBJ_H_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_OBJ_H_SID11_Pos) & DSPIC33_CANFD_FLT_OBJ_H_SID11_Msk))
static inline uint16_t dspic33_canfd_flt_obj_h_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_OBJ_H_SID11_Msk) >> DSPIC33_CANFD_FLT_OBJ_H_SID11_Pos);
}
static inline uint16_t dspic33_canfd_flt_obj_h_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_OBJ_H_SID11_Msk) | DSPIC33_CANFD_FLT_OBJ_H_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. With DNCNT above 0 and standard frames they are compared with
 * data bits instead. Access rw:filter_disabled. A write has an effect only if filter_disabled
 * (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: data_filter_bits.
 * Register 3-53 p.51; §8.2.3
 */
#define DSPIC33_CANFD_FLT_OBJ_H_EID_Pos 0U
#define DSPIC33_CANFD_FLT_OBJ_H_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_FLT_OBJ_H_EID_Width 13U
#define DSPIC33_CANFD_FLT_OBJ_H_EID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_FLT_OBJ_H_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_FLT_OBJ_H_EID_Pos) & DSPIC33_CANFD_FLT_OBJ_H_EID_Msk))
static inline uint16_t dspic33_canfd_flt_obj_h_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_FLT_OBJ_H_EID_Msk) >> DSPIC33_CANFD_FLT_OBJ_H_EID_Pos);
}
static inline uint16_t dspic33_canfd_flt_obj_h_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_FLT_OBJ_H_EID_Msk) | DSPIC33_CANFD_FLT_OBJ_H_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_flt_obj_h(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    return &regs->FLT[n].FLTOBJH;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_flt_obj_h_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    uint16_t value = regs->FLT[n].FLTOBJH;
    regs->FLT[n].FLTOBJH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* MASKnL: CAN Mask Register Low.
 * Mask bits for the standard identifier and the low bits of the extended identifier.
 * Contradictions of the manual: example_9_1_mask, filter_bit_tables.
 * Register 3-54 p.52; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_MASK_L_OFFSET 0x1F4U
#define DSPIC33_CANFD_MASK_L_COUNT 32U
#define DSPIC33_CANFD_MASK_L_STRIDE 0x008U
#define DSPIC33_CANFD_MASK_L_FIRST 0U
#define DSPIC33_CANFD_MASK_L_RESET 0x0000U
#define DSPIC33_CANFD_MASK_L_RESET_MASK 0xFFFFU
/* MEID[4:0]: Extended identifier mask bits 4 to 0; 1 compares, 0 ignores the bit. With DNCNT above 0 and
 * standard frames they mask the data bits. Access rw:filter_disabled. A write has an effect only if
 * filter_disabled (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: data_filter_bits.
 * Register 3-54 p.52; §8.2.2
 */
#define DSPIC33_CANFD_MASK_L_MEID_Pos 11U
#define DSPIC33_CANFD_MASK_L_MEID_Msk 0xF800U
#define DSPIC33_CANFD_MASK_L_MEID_Width 5U
#define DSPIC33_CANFD_MASK_L_MEID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_MASK_L_MEID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_MASK_L_MEID_Pos) & DSPIC33_CANFD_MASK_L_MEID_Msk))
static inline uint16_t dspic33_canfd_mask_l_meid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_MASK_L_MEID_Msk) >> DSPIC33_CANFD_MASK_L_MEID_Pos);
}
static inline uint16_t dspic33_canfd_mask_l_meid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_MASK_L_MEID_Msk) | DSPIC33_CANFD_MASK_L_MEID_SET(value));
}
/* MSID: Standard identifier mask; 1 compares, 0 ignores the bit. Access rw:filter_disabled. A write has an
 * effect only if filter_disabled (!FLTCON.FLTEN[n]).
 * Register 3-54 p.52; §8.2.2
 */
#define DSPIC33_CANFD_MASK_L_MSID_Pos 0U
#define DSPIC33_CANFD_MASK_L_MSID_Msk 0x07FFU
#define DSPIC33_CANFD_MASK_L_MSID_Width 11U
#define DSPIC33_CANFD_MASK_L_MSID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_MASK_L_MSID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_MASK_L_MSID_Pos) & DSPIC33_CANFD_MASK_L_MSID_Msk))
static inline uint16_t dspic33_canfd_mask_l_msid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_MASK_L_MSID_Msk) >> DSPIC33_CANFD_MASK_L_MSID_Pos);
}
static inline uint16_t dspic33_canfd_mask_l_msid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_MASK_L_MSID_Msk) | DSPIC33_CANFD_MASK_L_MSID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_mask_l(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    return &regs->FLT[n].MASKL;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_mask_l_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    uint16_t value = regs->FLT[n].MASKL;
    regs->FLT[n].MASKL = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* MASKnH: CAN Mask Register High.
 * Mask bits for the frame type, SID11 and the high bits of the extended identifier.
 * Contradictions of the manual: example_9_1_mask.
 * Register 3-55 p.52; external: mcp251xfd (offset)
 */
#define DSPIC33_CANFD_MASK_H_OFFSET 0x1F6U
#define DSPIC33_CANFD_MASK_H_COUNT 32U
#define DSPIC33_CANFD_MASK_H_STRIDE 0x008U
#define DSPIC33_CANFD_MASK_H_FIRST 0U
#define DSPIC33_CANFD_MASK_H_RESET 0x0000U
#define DSPIC33_CANFD_MASK_H_RESET_MASK 0xFFFFU
/* MIDE: Whether the frame type matters. Access rw:filter_disabled. A write has an effect only if filter_disabled
 * (!FLTCON.FLTEN[n]).
 * Register 3-55 p.52; §8.2.1
 */
#define DSPIC33_CANFD_MASK_H_MIDE_Pos 14U
#define DSPIC33_CANFD_MASK_H_MIDE_Msk 0x4000U
#define DSPIC33_CANFD_MASK_H_MIDE_Width 1U
#define DSPIC33_CANFD_MASK_H_MIDE_Access "rw:filter_disabled"
#define DSPIC33_CANFD_MASK_H_MIDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_MASK_H_MIDE_Pos) & DSPIC33_CANFD_MASK_H_MIDE_Msk))
static inline uint16_t dspic33_canfd_mask_h_mide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_MASK_H_MIDE_Msk) >> DSPIC33_CANFD_MASK_H_MIDE_Pos);
}
static inline uint16_t dspic33_canfd_mask_h_mide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_MASK_H_MIDE_Msk) | DSPIC33_CANFD_MASK_H_MIDE_SET(value));
}
/* MSID11: Mask bit for SID11; 1 compares, 0 ignores the bit. Access rw:filter_disabled. A write has an effect
 * only if filter_disabled (!FLTCON.FLTEN[n]).
 */
#define DSPIC33_CANFD_MASK_H_MSID11_Pos 13U
#define DSPIC33_CANFD_MASK_H_MSID11_Msk 0x2000U
#define DSPIC33_CANFD_MASK_H_MSID11_Width 1U
#define DSPIC33_CANFD_MASK_H_MSID11_Access "rw:filter_disabled"
#define DSPIC33_CANFD_MASK_H_MSID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_MASK_H_MSID11_Pos) & DSPIC33_CANFD_MASK_H_MSID11_Msk))
static inline uint16_t dspic33_canfd_mask_h_msid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_MASK_H_MSID11_Msk) >> DSPIC33_CANFD_MASK_H_MSID11_Pos);
}
static inline uint16_t dspic33_canfd_mask_h_msid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_MASK_H_MSID11_Msk) | DSPIC33_CANFD_MASK_H_MSID11_SET(value));
}
/* MEID[17:5]: Extended identifier mask bits 17 to 5; 1 compares, 0 ignores the bit. With DNCNT above 0 and
 * standard frames they mask the data bits. Access rw:filter_disabled. A write has an effect only if
 * filter_disabled (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: data_filter_bits.
 * Register 3-55 p.52; §8.2.2
 */
#define DSPIC33_CANFD_MASK_H_MEID_Pos 0U
#define DSPIC33_CANFD_MASK_H_MEID_Msk 0x1FFFU
#define DSPIC33_CANFD_MASK_H_MEID_Width 13U
#define DSPIC33_CANFD_MASK_H_MEID_Access "rw:filter_disabled"
#define DSPIC33_CANFD_MASK_H_MEID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_MASK_H_MEID_Pos) & DSPIC33_CANFD_MASK_H_MEID_Msk))
static inline uint16_t dspic33_canfd_mask_h_meid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_MASK_H_MEID_Msk) >> DSPIC33_CANFD_MASK_H_MEID_Pos);
}
static inline uint16_t dspic33_canfd_mask_h_meid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_MASK_H_MEID_Msk) | DSPIC33_CANFD_MASK_H_MEID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint16_t *dspic33_canfd_mask_h(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    return &regs->FLT[n].MASKH;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void dspic33_canfd_mask_h_modify(dspic33_canfd_regs_t *regs, unsigned int n, uint16_t clear, uint16_t set)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    uint16_t value = regs->FLT[n].MASKH;
    regs->FLT[n].MASKH = (uint16_t)((value & (uint16_t)~clear) | set);
}

/* NBTCFG: Nominal bit timing as one 32-bit value.
 * Accessed in the order NBTCFGL, NBTCFGH.
 * Register 3-3; Register 3-4
 */
static inline uint32_t dspic33_canfd_nbtcfg_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->NBTCFGL;
    const uint16_t part1 = regs->NBTCFGH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_nbtcfg_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->NBTCFGL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->NBTCFGH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* DBTCFG: Data bit timing as one 32-bit value.
 * Accessed in the order DBTCFGL, DBTCFGH.
 * Register 3-5; Register 3-6
 */
static inline uint32_t dspic33_canfd_dbtcfg_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->DBTCFGL;
    const uint16_t part1 = regs->DBTCFGH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_dbtcfg_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->DBTCFGL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->DBTCFGH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* TDC: Transmitter delay compensation as one 32-bit value.
 * Accessed in the order TDCL, TDCH.
 * Register 3-7; Register 3-8
 */
static inline uint32_t dspic33_canfd_tdc_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TDCL;
    const uint16_t part1 = regs->TDCH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_tdc_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->TDCL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->TDCH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* TBC: Time Base Counter. It may roll over between the reads of the halves.
 * Accessed in the order TBCL, TBCH.
 * Register 3-9; Register 3-10; §11.0 p.108
 */
static inline uint32_t dspic33_canfd_tbc_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TBCL;
    const uint16_t part1 = regs->TBCH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_tbc_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->TBCL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->TBCH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* TSCON: Timestamp control as one 32-bit value.
 * Accessed in the order TSCONL, TSCONH.
 * Register 3-11; Register 3-12
 */
static inline uint32_t dspic33_canfd_tscon_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TSCONL;
    const uint16_t part1 = regs->TSCONH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_tscon_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->TSCONL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->TSCONH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* VEC: All interrupt codes as one 32-bit value.
 * Accessed in the order VECL, VECH.
 * Register 3-13; Register 3-14
 */
static inline uint32_t dspic33_canfd_vec_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->VECL;
    const uint16_t part1 = regs->VECH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* RXIF: Receive interrupts; bit n is FIFO n, bit 0 is unimplemented.
 * Accessed in the order RXIFL, RXIFH.
 * Register 3-17; Register 3-18
 */
static inline uint32_t dspic33_canfd_rxif_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->RXIFL;
    const uint16_t part1 = regs->RXIFH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* RXOVIF: Receive overflows; bit n is FIFO n, bit 0 is unimplemented.
 * Accessed in the order RXOVIFL, RXOVIFH.
 * Register 3-19; Register 3-20
 */
static inline uint32_t dspic33_canfd_rxovif_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->RXOVIFL;
    const uint16_t part1 = regs->RXOVIFH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* TXIF: Transmit interrupts; bit n is FIFO n, bit 0 the transmit queue.
 * Accessed in the order TXIFL, TXIFH.
 * Register 3-21; Register 3-22
 */
static inline uint32_t dspic33_canfd_txif_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TXIFL;
    const uint16_t part1 = regs->TXIFH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* TXATIF: Exhausted transmit attempts; bit n is FIFO n, bit 0 the transmit queue.
 * Accessed in the order TXATIFL, TXATIFH.
 * Register 3-23; Register 3-24
 */
static inline uint32_t dspic33_canfd_txatif_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TXATIFL;
    const uint16_t part1 = regs->TXATIFH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* TXREQ: Transmission requests; bit n is FIFO n, bit 0 the transmit queue.
 * Accessed in the order TXREQL, TXREQH.
 * Register 3-25; Register 3-26; §6.6
 */
static inline uint32_t dspic33_canfd_txreq_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TXREQL;
    const uint16_t part1 = regs->TXREQH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_txreq_request(dspic33_canfd_regs_t *regs, uint32_t requests)
{
    dspic33_canfd_txreq_l_request(regs, (uint16_t)(((uint16_t)(requests >> 0U) << 0U) & 0xFFFFU));
    dspic33_canfd_txreq_h_request(regs, (uint16_t)(((uint16_t)(requests >> 16U) << 0U) & 0xFFFFU));
}

/* FIFOBA: RAM address at which the message objects begin, aligned to 4 bytes.
 * Accessed in the order FIFOBAL, FIFOBAH.
 * Register 3-27; Register 3-28
 */
static inline uint32_t dspic33_canfd_fifoba_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->FIFOBAL;
    const uint16_t part1 = regs->FIFOBAH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_fifoba_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->FIFOBAL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->FIFOBAH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* TEFUA: Address of the next event to read.
 * Accessed in the order TEFUAL, TEFUAH.
 * Register 3-40; Register 3-41
 */
static inline uint32_t dspic33_canfd_tefua_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TEFUAL;
    const uint16_t part1 = regs->TEFUAH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* TXQUA: Address of the next free object of the transmit queue.
 * Accessed in the order TXQUAL, TXQUAH.
 * Register 3-42; Register 3-43
 */
static inline uint32_t dspic33_canfd_txqua_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TXQUAL;
    const uint16_t part1 = regs->TXQUAH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* TREC: Error counters and error states as one 32-bit value.
 * Accessed in the order TRECL, TRECH.
 * Register 3-44; Register 3-45
 */
static inline uint32_t dspic33_canfd_trec_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->TRECL;
    const uint16_t part1 = regs->TRECH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* BDIAG0: The four diagnostic error counters as one 32-bit value.
 * Accessed in the order BDIAG0L, BDIAG0H.
 * Register 3-46; Register 3-47
 */
static inline uint32_t dspic33_canfd_bdiag0_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->BDIAG0L;
    const uint16_t part1 = regs->BDIAG0H;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_bdiag0_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->BDIAG0L = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->BDIAG0H = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* BDIAG1: Error-free message counter and diagnostic flags as one 32-bit value.
 * Accessed in the order BDIAG1L, BDIAG1H.
 * Register 3-48; Register 3-49
 */
static inline uint32_t dspic33_canfd_bdiag1_read(dspic33_canfd_regs_t *regs)
{
    const uint16_t part0 = regs->BDIAG1L;
    const uint16_t part1 = regs->BDIAG1H;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_bdiag1_write(dspic33_canfd_regs_t *regs, uint32_t value)
{
    regs->BDIAG1L = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->BDIAG1H = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* FIFOUA: User address: the object to fill next (transmit) or to read next (receive).
 * Accessed in the order FIFOUAnL, FIFOUAnH.
 * Register 3-38; Register 3-39
 */
static inline uint32_t dspic33_canfd_fifo_ua_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n - 1U < 31U);
    const uint16_t part0 = regs->FIFO[n - 1U].FIFOUAL;
    const uint16_t part1 = regs->FIFO[n - 1U].FIFOUAH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}

/* FLTOBJ: Filter object as one 32-bit value.
 * Accessed in the order FLTOBJnL, FLTOBJnH.
 * Register 3-52 p.51; Register 3-53 p.51
 */
static inline uint32_t dspic33_canfd_flt_obj_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].FLTOBJL;
    const uint16_t part1 = regs->FLT[n].FLTOBJH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_flt_obj_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    regs->FLT[n].FLTOBJL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->FLT[n].FLTOBJH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* MASK: Mask as one 32-bit value.
 * Accessed in the order MASKnL, MASKnH.
 * Register 3-54 p.52; Register 3-55 p.52
 */
static inline uint32_t dspic33_canfd_mask_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].MASKL;
    const uint16_t part1 = regs->FLT[n].MASKH;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_mask_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    regs->FLT[n].MASKL = (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    regs->FLT[n].MASKH = (uint16_t)((uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* EID: Extended identifier, 18 bits.
 * Accessed in the order FLTOBJnL, FLTOBJnH.
 * Register 3-52 p.51; Register 3-53 p.51
 */
static inline uint32_t dspic33_canfd_eid_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].FLTOBJL;
    const uint16_t part1 = regs->FLT[n].FLTOBJH;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_eid_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    dspic33_canfd_flt_obj_l_modify(regs, n, 0xF800U, (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U)));
    dspic33_canfd_flt_obj_h_modify(regs, n, 0x1FFFU, (uint16_t)((uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU)));
}

/* MEID: Extended identifier mask, 18 bits.
 * Accessed in the order MASKnL, MASKnH.
 * Register 3-54 p.52; Register 3-55 p.52
 */
static inline uint32_t dspic33_canfd_meid_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].MASKL;
    const uint16_t part1 = regs->FLT[n].MASKH;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_meid_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    dspic33_canfd_mask_l_modify(regs, n, 0xF800U, (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U)));
    dspic33_canfd_mask_h_modify(regs, n, 0x1FFFU, (uint16_t)((uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU)));
}

/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Accessed in the order FLTOBJnH, FLTOBJnL.
 * Register 3-8; §8.2.4
 */
static inline uint32_t dspic33_canfd_sid12_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].FLTOBJH;
    const uint16_t part1 = regs->FLT[n].FLTOBJL;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_sid12_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    dspic33_canfd_flt_obj_h_modify(regs, n, 0x2000U, (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U)));
    dspic33_canfd_flt_obj_l_modify(regs, n, 0x07FFU, (uint16_t)((uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU)));
}

/* MSID12: Mask of the 12-bit standard identifier; MSID11 is its least significant bit.
 * Accessed in the order MASKnH, MASKnL.
 * Register 3-8; §8.2.4
 */
static inline uint32_t dspic33_canfd_msid12_read(dspic33_canfd_regs_t *regs, unsigned int n)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    const uint16_t part0 = regs->FLT[n].MASKH;
    const uint16_t part1 = regs->FLT[n].MASKL;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_msid12_write(dspic33_canfd_regs_t *regs, unsigned int n, uint32_t value)
{
    DSPIC33_CANFD_ASSERT(n < 32U);
    dspic33_canfd_mask_h_modify(regs, n, 0x2000U, (uint16_t)((uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U)));
    dspic33_canfd_mask_l_modify(regs, n, 0x07FFU, (uint16_t)((uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU)));
}

/* TX_OBJECT: Transmit Message Object.
 * A message to send, in the queue or in a transmit FIFO. Unimplemented bits read unknown and are ignored. It
 * never holds a timestamp.
 * Only the bytes that the DLC counts have to be loaded; byte 0 is sent first and stands in the low half of its
 * word.
 * Table 6-1; §6.1
 */
typedef struct {
    volatile uint16_t T0; /* Standard identifier and low bits of the extended identifier. */
    volatile uint16_t T1; /* SID11 and high bits of the extended identifier. */
    volatile uint16_t T2; /* Control bits and low bits of the sequence number. */
    volatile uint16_t T3; /* High bits of the sequence number. */
    volatile uint16_t PAYLOAD[32];
} dspic33_canfd_tx_object_t;
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tx_object_t, T0) == 0x000U, dspic33_canfd_tx_object_at_T0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tx_object_t, T1) == 0x002U, dspic33_canfd_tx_object_at_T1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tx_object_t, T2) == 0x004U, dspic33_canfd_tx_object_at_T2);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tx_object_t, T3) == 0x006U, dspic33_canfd_tx_object_at_T3);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tx_object_t, PAYLOAD) == 0x008U, dspic33_canfd_tx_object_at_PAYLOAD);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tx_object_t) == 0x048U, dspic33_canfd_tx_object_size);
#define DSPIC33_CANFD_TX_OBJECT_HEADER_BYTES 8U
/* Word T0 of TX_OBJECT: Standard identifier and low bits of the extended identifier.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TX_OBJECT_T0_OFFSET 0x000U
/* EID[4:0]: Extended identifier bits 4 to 0. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T0_EID_Pos 11U
#define DSPIC33_CANFD_TX_OBJECT_T0_EID_Msk 0xF800U
#define DSPIC33_CANFD_TX_OBJECT_T0_EID_Width 5U
#define DSPIC33_CANFD_TX_OBJECT_T0_EID_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T0_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T0_EID_Pos) & DSPIC33_CANFD_TX_OBJECT_T0_EID_Msk))
static inline uint16_t dspic33_canfd_tx_object_t0_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T0_EID_Msk) >> DSPIC33_CANFD_TX_OBJECT_T0_EID_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t0_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T0_EID_Msk) | DSPIC33_CANFD_TX_OBJECT_T0_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T0_SID_Pos 0U
#define DSPIC33_CANFD_TX_OBJECT_T0_SID_Msk 0x07FFU
#define DSPIC33_CANFD_TX_OBJECT_T0_SID_Width 11U
#define DSPIC33_CANFD_TX_OBJECT_T0_SID_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T0_SID_Pos) & DSPIC33_CANFD_TX_OBJECT_T0_SID_Msk))
static inline uint16_t dspic33_canfd_tx_object_t0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T0_SID_Msk) >> DSPIC33_CANFD_TX_OBJECT_T0_SID_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T0_SID_Msk) | DSPIC33_CANFD_TX_OBJECT_T0_SID_SET(value));
}
/* Word T1 of TX_OBJECT: SID11 and high bits of the extended identifier.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TX_OBJECT_T1_OFFSET 0x002U
/* SID11: Least significant bit of a 12-bit standard identifier, the RRS bit of CAN FD base frames with SID11EN.
 * Access rw.
 */
#define DSPIC33_CANFD_TX_OBJECT_T1_SID11_Pos 13U
#define DSPIC33_CANFD_TX_OBJECT_T1_SID11_Msk 0x2000U
#define DSPIC33_CANFD_TX_OBJECT_T1_SID11_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T1_SID11_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T1_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T1_SID11_Pos) & DSPIC33_CANFD_TX_OBJECT_T1_SID11_Msk))
static inline uint16_t dspic33_canfd_tx_object_t1_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T1_SID11_Msk) >> DSPIC33_CANFD_TX_OBJECT_T1_SID11_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t1_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T1_SID11_Msk) | DSPIC33_CANFD_TX_OBJECT_T1_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T1_EID_Pos 0U
#define DSPIC33_CANFD_TX_OBJECT_T1_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_TX_OBJECT_T1_EID_Width 13U
#define DSPIC33_CANFD_TX_OBJECT_T1_EID_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T1_EID_Pos) & DSPIC33_CANFD_TX_OBJECT_T1_EID_Msk))
static inline uint16_t dspic33_canfd_tx_object_t1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T1_EID_Msk) >> DSPIC33_CANFD_TX_OBJECT_T1_EID_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T1_EID_Msk) | DSPIC33_CANFD_TX_OBJECT_T1_EID_SET(value));
}
/* Word T2 of TX_OBJECT: Control bits and low bits of the sequence number.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TX_OBJECT_T2_OFFSET 0x004U
/* SEQ[6:0]: Bits 6 to 0 of a number that software chooses to recognize the message in the transmit event FIFO;
 * not sent on the bus. Access rw.
 */
#define DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Pos 9U
#define DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Msk 0xFE00U
#define DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Width 7U
#define DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_seq_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_SEQ_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_SEQ_SET(value));
}
/* ESI: With ESIGM set, 1 sends a recessive ESI whatever the state of this controller; otherwise ignored. Access
 * rw.
 */
#define DSPIC33_CANFD_TX_OBJECT_T2_ESI_Pos 8U
#define DSPIC33_CANFD_TX_OBJECT_T2_ESI_Msk 0x0100U
#define DSPIC33_CANFD_TX_OBJECT_T2_ESI_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T2_ESI_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_ESI_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_ESI_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_ESI_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_ESI_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_ESI_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_ESI_SET(value));
}
/* FDF: Frame format; ignored in Normal CAN 2.0 mode. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T2_FDF_Pos 7U
#define DSPIC33_CANFD_TX_OBJECT_T2_FDF_Msk 0x0080U
#define DSPIC33_CANFD_TX_OBJECT_T2_FDF_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T2_FDF_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_FDF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_FDF_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_FDF_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_fdf_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_FDF_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_FDF_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_fdf_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_FDF_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_FDF_SET(value));
}
/* BRS: Bit rate of the data phase of a CAN FD frame. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T2_BRS_Pos 6U
#define DSPIC33_CANFD_TX_OBJECT_T2_BRS_Msk 0x0040U
#define DSPIC33_CANFD_TX_OBJECT_T2_BRS_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T2_BRS_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_BRS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_BRS_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_BRS_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_brs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_BRS_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_BRS_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_brs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_BRS_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_BRS_SET(value));
}
/* RTR: Remote transmission request; CAN 2.0 frames only. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T2_RTR_Pos 5U
#define DSPIC33_CANFD_TX_OBJECT_T2_RTR_Msk 0x0020U
#define DSPIC33_CANFD_TX_OBJECT_T2_RTR_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T2_RTR_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_RTR_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_RTR_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_RTR_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_RTR_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_RTR_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_RTR_SET(value));
}
/* IDE: Identifier format. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T2_IDE_Pos 4U
#define DSPIC33_CANFD_TX_OBJECT_T2_IDE_Msk 0x0010U
#define DSPIC33_CANFD_TX_OBJECT_T2_IDE_Width 1U
#define DSPIC33_CANFD_TX_OBJECT_T2_IDE_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_IDE_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_IDE_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_IDE_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_IDE_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_IDE_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_IDE_SET(value));
}
/* DLC: Data length code. A length above the payload size is not sent: IVMIF and DLCMM are set, TXREQ is cleared.
 * Access rw.
 * Table 6-1; §6.12
 */
#define DSPIC33_CANFD_TX_OBJECT_T2_DLC_Pos 0U
#define DSPIC33_CANFD_TX_OBJECT_T2_DLC_Msk 0x000FU
#define DSPIC33_CANFD_TX_OBJECT_T2_DLC_Width 4U
#define DSPIC33_CANFD_TX_OBJECT_T2_DLC_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T2_DLC_Pos) & DSPIC33_CANFD_TX_OBJECT_T2_DLC_Msk))
static inline uint16_t dspic33_canfd_tx_object_t2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T2_DLC_Msk) >> DSPIC33_CANFD_TX_OBJECT_T2_DLC_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T2_DLC_Msk) | DSPIC33_CANFD_TX_OBJECT_T2_DLC_SET(value));
}
/* Word T3 of TX_OBJECT: High bits of the sequence number.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TX_OBJECT_T3_OFFSET 0x006U
/* SEQ[22:7]: Bits 22 to 7 of the sequence number. Access rw. */
#define DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Pos 0U
#define DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Msk 0xFFFFU
#define DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Width 16U
#define DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Access "rw"
#define DSPIC33_CANFD_TX_OBJECT_T3_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Pos) & DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Msk))
static inline uint16_t dspic33_canfd_tx_object_t3_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Msk) >> DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tx_object_t3_seq_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TX_OBJECT_T3_SEQ_Msk) | DSPIC33_CANFD_TX_OBJECT_T3_SEQ_SET(value));
}
#define DSPIC33_CANFD_TX_OBJECT_PAYLOAD_MAX 64U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define DSPIC33_CANFD_TX_OBJECT_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int dspic33_canfd_tx_object_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    case 1U: return 12U;
    case 2U: return 16U;
    case 3U: return 20U;
    case 4U: return 24U;
    case 5U: return 32U;
    case 6U: return 48U;
    case 7U: return 64U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void dspic33_canfd_tx_object_read_payload(const dspic33_canfd_tx_object_t *element, uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        const uint16_t word = element->PAYLOAD[at / 2U];
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void dspic33_canfd_tx_object_write_payload(dspic33_canfd_tx_object_t *element, const uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        uint16_t word = 0;
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            word = (uint16_t)(word | (uint16_t)((uint16_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 2U] = word;
    }
}
/* EID: Extended identifier, 18 bits. */
static inline uint32_t dspic33_canfd_tx_object_eid_read(const dspic33_canfd_tx_object_t *element)
{
    const uint16_t part0 = element->T0;
    const uint16_t part1 = element->T1;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_tx_object_eid_write(dspic33_canfd_tx_object_t *element, uint32_t value)
{
    element->T0 = (uint16_t)((element->T0 & (uint16_t)~0xF800U) | (uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U));
    element->T1 = (uint16_t)((element->T1 & (uint16_t)~0x1FFFU) | (uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU));
}
/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Register 3-8
 */
static inline uint32_t dspic33_canfd_tx_object_sid12_read(const dspic33_canfd_tx_object_t *element)
{
    const uint16_t part0 = element->T1;
    const uint16_t part1 = element->T0;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_tx_object_sid12_write(dspic33_canfd_tx_object_t *element, uint32_t value)
{
    element->T1 = (uint16_t)((element->T1 & (uint16_t)~0x2000U) | (uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U));
    element->T0 = (uint16_t)((element->T0 & (uint16_t)~0x07FFU) | (uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU));
}
/* SEQ: Sequence number, 23 bits. */
static inline uint32_t dspic33_canfd_tx_object_seq_read(const dspic33_canfd_tx_object_t *element)
{
    const uint16_t part0 = element->T2;
    const uint16_t part1 = element->T3;
    return ((uint32_t)((part0 & 0xFE00U) >> 9U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 7U);
}
static inline void dspic33_canfd_tx_object_seq_write(dspic33_canfd_tx_object_t *element, uint32_t value)
{
    element->T2 = (uint16_t)((element->T2 & (uint16_t)~0xFE00U) | (uint16_t)(((uint16_t)(value >> 0U) << 9U) & 0xFE00U));
    element->T3 = (uint16_t)((element->T3 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 7U) << 0U) & 0xFFFFU));
}

/* RX_OBJECT: Receive Message Object.
 * A received message in a receive FIFO without timestamps (RXTSEN = 0). Unimplemented bits read unknown.
 * Bytes beyond the payload size are discarded without touching the next object; IVMIF and DLCMM are then set. A
 * shorter message is stored without padding. The data words are R6 and up even without a timestamp, because R4
 * and R5 then do not exist.
 * Table 9-1; §9.1
 */
typedef struct {
    volatile uint16_t R0; /* Standard identifier and low bits of the extended identifier. */
    volatile uint16_t R1; /* SID11 and high bits of the extended identifier. */
    volatile uint16_t R2; /* Filter number and control bits. */
    volatile uint16_t R3; /* Unimplemented; reads unknown. */
    volatile uint16_t PAYLOAD[32];
} dspic33_canfd_rx_object_t;
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_t, R0) == 0x000U, dspic33_canfd_rx_object_at_R0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_t, R1) == 0x002U, dspic33_canfd_rx_object_at_R1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_t, R2) == 0x004U, dspic33_canfd_rx_object_at_R2);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_t, R3) == 0x006U, dspic33_canfd_rx_object_at_R3);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_t, PAYLOAD) == 0x008U, dspic33_canfd_rx_object_at_PAYLOAD);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rx_object_t) == 0x048U, dspic33_canfd_rx_object_size);
#define DSPIC33_CANFD_RX_OBJECT_HEADER_BYTES 8U
/* Word R0 of RX_OBJECT: Standard identifier and low bits of the extended identifier.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_R0_OFFSET 0x000U
/* EID[4:0]: Extended identifier bits 4 to 0. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_R0_EID_Pos 11U
#define DSPIC33_CANFD_RX_OBJECT_R0_EID_Msk 0xF800U
#define DSPIC33_CANFD_RX_OBJECT_R0_EID_Width 5U
#define DSPIC33_CANFD_RX_OBJECT_R0_EID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R0_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R0_EID_Pos) & DSPIC33_CANFD_RX_OBJECT_R0_EID_Msk))
static inline uint16_t dspic33_canfd_rx_object_r0_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R0_EID_Msk) >> DSPIC33_CANFD_RX_OBJECT_R0_EID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r0_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R0_EID_Msk) | DSPIC33_CANFD_RX_OBJECT_R0_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_R0_SID_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_R0_SID_Msk 0x07FFU
#define DSPIC33_CANFD_RX_OBJECT_R0_SID_Width 11U
#define DSPIC33_CANFD_RX_OBJECT_R0_SID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R0_SID_Pos) & DSPIC33_CANFD_RX_OBJECT_R0_SID_Msk))
static inline uint16_t dspic33_canfd_rx_object_r0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R0_SID_Msk) >> DSPIC33_CANFD_RX_OBJECT_R0_SID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R0_SID_Msk) | DSPIC33_CANFD_RX_OBJECT_R0_SID_SET(value));
}
/* Word R1 of RX_OBJECT: SID11 and high bits of the extended identifier.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_R1_OFFSET 0x002U
/* SID11: Least significant bit of a 12-bit standard identifier, the RRS bit of CAN FD base frames with SID11EN.
 * Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_R1_SID11_Pos 13U
#define DSPIC33_CANFD_RX_OBJECT_R1_SID11_Msk 0x2000U
#define DSPIC33_CANFD_RX_OBJECT_R1_SID11_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R1_SID11_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R1_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R1_SID11_Pos) & DSPIC33_CANFD_RX_OBJECT_R1_SID11_Msk))
static inline uint16_t dspic33_canfd_rx_object_r1_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R1_SID11_Msk) >> DSPIC33_CANFD_RX_OBJECT_R1_SID11_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r1_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R1_SID11_Msk) | DSPIC33_CANFD_RX_OBJECT_R1_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_R1_EID_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_R1_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_RX_OBJECT_R1_EID_Width 13U
#define DSPIC33_CANFD_RX_OBJECT_R1_EID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R1_EID_Pos) & DSPIC33_CANFD_RX_OBJECT_R1_EID_Msk))
static inline uint16_t dspic33_canfd_rx_object_r1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R1_EID_Msk) >> DSPIC33_CANFD_RX_OBJECT_R1_EID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R1_EID_Msk) | DSPIC33_CANFD_RX_OBJECT_R1_EID_SET(value));
}
/* Word R2 of RX_OBJECT: Filter number and control bits.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_R2_OFFSET 0x004U
/* FILHIT: Number of the filter that accepted the message. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Pos 11U
#define DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Msk 0xF800U
#define DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Width 5U
#define DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_filhit_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_filhit_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_FILHIT_SET(value));
}
/* ESI: Error state of the node that sent the message. Access rw.
 * §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_R2_ESI_Pos 8U
#define DSPIC33_CANFD_RX_OBJECT_R2_ESI_Msk 0x0100U
#define DSPIC33_CANFD_RX_OBJECT_R2_ESI_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R2_ESI_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_ESI_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_ESI_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_ESI_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_ESI_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_ESI_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_ESI_SET(value));
}
/* FDF: Frame format. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_R2_FDF_Pos 7U
#define DSPIC33_CANFD_RX_OBJECT_R2_FDF_Msk 0x0080U
#define DSPIC33_CANFD_RX_OBJECT_R2_FDF_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R2_FDF_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_FDF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_FDF_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_FDF_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_fdf_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_FDF_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_FDF_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_fdf_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_FDF_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_FDF_SET(value));
}
/* BRS: Bit rate of the data phase of a CAN FD frame. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_R2_BRS_Pos 6U
#define DSPIC33_CANFD_RX_OBJECT_R2_BRS_Msk 0x0040U
#define DSPIC33_CANFD_RX_OBJECT_R2_BRS_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R2_BRS_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_BRS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_BRS_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_BRS_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_brs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_BRS_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_BRS_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_brs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_BRS_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_BRS_SET(value));
}
/* RTR: The frame was a remote frame; CAN 2.0 frames only. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_R2_RTR_Pos 5U
#define DSPIC33_CANFD_RX_OBJECT_R2_RTR_Msk 0x0020U
#define DSPIC33_CANFD_RX_OBJECT_R2_RTR_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R2_RTR_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_RTR_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_RTR_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_RTR_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_RTR_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_RTR_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_RTR_SET(value));
}
/* IDE: Identifier format. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_R2_IDE_Pos 4U
#define DSPIC33_CANFD_RX_OBJECT_R2_IDE_Msk 0x0010U
#define DSPIC33_CANFD_RX_OBJECT_R2_IDE_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_R2_IDE_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_IDE_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_IDE_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_IDE_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_IDE_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_IDE_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_IDE_SET(value));
}
/* DLC: Data length code as received, which may exceed the payload size. Access rw.
 * Table 9-1; §9.4
 */
#define DSPIC33_CANFD_RX_OBJECT_R2_DLC_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_R2_DLC_Msk 0x000FU
#define DSPIC33_CANFD_RX_OBJECT_R2_DLC_Width 4U
#define DSPIC33_CANFD_RX_OBJECT_R2_DLC_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_R2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_R2_DLC_Pos) & DSPIC33_CANFD_RX_OBJECT_R2_DLC_Msk))
static inline uint16_t dspic33_canfd_rx_object_r2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_R2_DLC_Msk) >> DSPIC33_CANFD_RX_OBJECT_R2_DLC_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_r2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_R2_DLC_Msk) | DSPIC33_CANFD_RX_OBJECT_R2_DLC_SET(value));
}
/* Word R3 of RX_OBJECT: Unimplemented; reads unknown.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_R3_OFFSET 0x006U
#define DSPIC33_CANFD_RX_OBJECT_PAYLOAD_MAX 64U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define DSPIC33_CANFD_RX_OBJECT_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int dspic33_canfd_rx_object_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    case 1U: return 12U;
    case 2U: return 16U;
    case 3U: return 20U;
    case 4U: return 24U;
    case 5U: return 32U;
    case 6U: return 48U;
    case 7U: return 64U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void dspic33_canfd_rx_object_read_payload(const dspic33_canfd_rx_object_t *element, uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        const uint16_t word = element->PAYLOAD[at / 2U];
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void dspic33_canfd_rx_object_write_payload(dspic33_canfd_rx_object_t *element, const uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        uint16_t word = 0;
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            word = (uint16_t)(word | (uint16_t)((uint16_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 2U] = word;
    }
}
/* EID: Extended identifier, 18 bits. */
static inline uint32_t dspic33_canfd_rx_object_eid_read(const dspic33_canfd_rx_object_t *element)
{
    const uint16_t part0 = element->R0;
    const uint16_t part1 = element->R1;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_rx_object_eid_write(dspic33_canfd_rx_object_t *element, uint32_t value)
{
    element->R0 = (uint16_t)((element->R0 & (uint16_t)~0xF800U) | (uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U));
    element->R1 = (uint16_t)((element->R1 & (uint16_t)~0x1FFFU) | (uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU));
}
/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Register 3-8
 */
static inline uint32_t dspic33_canfd_rx_object_sid12_read(const dspic33_canfd_rx_object_t *element)
{
    const uint16_t part0 = element->R1;
    const uint16_t part1 = element->R0;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_rx_object_sid12_write(dspic33_canfd_rx_object_t *element, uint32_t value)
{
    element->R1 = (uint16_t)((element->R1 & (uint16_t)~0x2000U) | (uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U));
    element->R0 = (uint16_t)((element->R0 & (uint16_t)~0x07FFU) | (uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU));
}

/* RX_OBJECT_TS: Receive Message Object with Timestamp.
 * A received message in a receive FIFO with timestamps (RXTSEN = 1). The data bytes stand 4 bytes further back.
 * As in the object without timestamp.
 * Table 9-1; §9.1
 */
typedef struct {
    volatile uint16_t R0; /* Standard identifier and low bits of the extended identifier. */
    volatile uint16_t R1; /* SID11 and high bits of the extended identifier. */
    volatile uint16_t R2; /* Filter number and control bits. */
    volatile uint16_t R3; /* Unimplemented; reads unknown. */
    volatile uint16_t R4; /* Low half of the timestamp. */
    volatile uint16_t R5; /* High half of the timestamp. */
    volatile uint16_t PAYLOAD[32];
} dspic33_canfd_rx_object_ts_t;
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R0) == 0x000U, dspic33_canfd_rx_object_ts_at_R0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R1) == 0x002U, dspic33_canfd_rx_object_ts_at_R1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R2) == 0x004U, dspic33_canfd_rx_object_ts_at_R2);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R3) == 0x006U, dspic33_canfd_rx_object_ts_at_R3);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R4) == 0x008U, dspic33_canfd_rx_object_ts_at_R4);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, R5) == 0x00AU, dspic33_canfd_rx_object_ts_at_R5);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_rx_object_ts_t, PAYLOAD) == 0x00CU, dspic33_canfd_rx_object_ts_at_PAYLOAD);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rx_object_ts_t) == 0x04CU, dspic33_canfd_rx_object_ts_size);
#define DSPIC33_CANFD_RX_OBJECT_TS_HEADER_BYTES 12U
/* Word R0 of RX_OBJECT_TS: Standard identifier and low bits of the extended identifier.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_OFFSET 0x000U
/* EID[4:0]: Extended identifier bits 4 to 0. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Pos 11U
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Msk 0xF800U
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Width 5U
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r0_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r0_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R0_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Msk 0x07FFU
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Width 11U
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R0_SID_SET(value));
}
/* Word R1 of RX_OBJECT_TS: SID11 and high bits of the extended identifier.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_OFFSET 0x002U
/* SID11: Least significant bit of a 12-bit standard identifier, the RRS bit of CAN FD base frames with SID11EN.
 * Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Pos 13U
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Msk 0x2000U
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r1_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r1_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R1_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Width 13U
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R1_EID_SET(value));
}
/* Word R2 of RX_OBJECT_TS: Filter number and control bits.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_OFFSET 0x004U
/* FILHIT: Number of the filter that accepted the message. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Pos 11U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Msk 0xF800U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Width 5U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_filhit_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_filhit_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_FILHIT_SET(value));
}
/* ESI: Error state of the node that sent the message. Access rw.
 * §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Pos 8U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Msk 0x0100U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_ESI_SET(value));
}
/* FDF: Frame format. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Pos 7U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Msk 0x0080U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_fdf_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_fdf_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_FDF_SET(value));
}
/* BRS: Bit rate of the data phase of a CAN FD frame. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Pos 6U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Msk 0x0040U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_brs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_brs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_BRS_SET(value));
}
/* RTR: The frame was a remote frame; CAN 2.0 frames only. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Pos 5U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Msk 0x0020U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_RTR_SET(value));
}
/* IDE: Identifier format. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Pos 4U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Msk 0x0010U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Width 1U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_IDE_SET(value));
}
/* DLC: Data length code as received, which may exceed the payload size. Access rw.
 * Table 9-1; §9.4
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Msk 0x000FU
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Width 4U
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R2_DLC_SET(value));
}
/* Word R3 of RX_OBJECT_TS: Unimplemented; reads unknown.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R3_OFFSET 0x006U
/* Word R4 of RX_OBJECT_TS: Low half of the timestamp.
 * Has this layout only if FIFOCONL.RXTSEN && !FIFOCONL.TXEN.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_OFFSET 0x008U
/* RXMSGTS[15:0]: Bits 15 to 0 of the Time Base Counter at the reference point of the message. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Msk 0xFFFFU
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Width 16U
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r4_rxmsgts_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r4_rxmsgts_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R4_RXMSGTS_SET(value));
}
/* Word R5 of RX_OBJECT_TS: High half of the timestamp.
 * Has this layout only if FIFOCONL.RXTSEN && !FIFOCONL.TXEN.
 * Table 9-1; §9.1
 */
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_OFFSET 0x00AU
/* RXMSGTS[31:16]: Bits 31 to 16 of the Time Base Counter at the reference point of the message. Access rw. */
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Pos 0U
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Msk 0xFFFFU
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Width 16U
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Access "rw"
#define DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Pos) & DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Msk))
static inline uint16_t dspic33_canfd_rx_object_ts_r5_rxmsgts_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Msk) >> DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Pos);
}
static inline uint16_t dspic33_canfd_rx_object_ts_r5_rxmsgts_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_Msk) | DSPIC33_CANFD_RX_OBJECT_TS_R5_RXMSGTS_SET(value));
}
#define DSPIC33_CANFD_RX_OBJECT_TS_PAYLOAD_MAX 64U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define DSPIC33_CANFD_RX_OBJECT_TS_BYTES(payload) (12U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int dspic33_canfd_rx_object_ts_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    case 1U: return 12U;
    case 2U: return 16U;
    case 3U: return 20U;
    case 4U: return 24U;
    case 5U: return 32U;
    case 6U: return 48U;
    case 7U: return 64U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void dspic33_canfd_rx_object_ts_read_payload(const dspic33_canfd_rx_object_ts_t *element, uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        const uint16_t word = element->PAYLOAD[at / 2U];
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void dspic33_canfd_rx_object_ts_write_payload(dspic33_canfd_rx_object_ts_t *element, const uint8_t *data, size_t count)
{
    DSPIC33_CANFD_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 2U) {
        uint16_t word = 0;
        for (size_t byte = 0; byte < 2U && at + byte < count; ++byte) {
            word = (uint16_t)(word | (uint16_t)((uint16_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 2U] = word;
    }
}
/* EID: Extended identifier, 18 bits. */
static inline uint32_t dspic33_canfd_rx_object_ts_eid_read(const dspic33_canfd_rx_object_ts_t *element)
{
    const uint16_t part0 = element->R0;
    const uint16_t part1 = element->R1;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_rx_object_ts_eid_write(dspic33_canfd_rx_object_ts_t *element, uint32_t value)
{
    element->R0 = (uint16_t)((element->R0 & (uint16_t)~0xF800U) | (uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U));
    element->R1 = (uint16_t)((element->R1 & (uint16_t)~0x1FFFU) | (uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU));
}
/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Register 3-8
 */
static inline uint32_t dspic33_canfd_rx_object_ts_sid12_read(const dspic33_canfd_rx_object_ts_t *element)
{
    const uint16_t part0 = element->R1;
    const uint16_t part1 = element->R0;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_rx_object_ts_sid12_write(dspic33_canfd_rx_object_ts_t *element, uint32_t value)
{
    element->R1 = (uint16_t)((element->R1 & (uint16_t)~0x2000U) | (uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U));
    element->R0 = (uint16_t)((element->R0 & (uint16_t)~0x07FFU) | (uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU));
}
/* RXMSGTS: Timestamp, 32 bits. */
static inline uint32_t dspic33_canfd_rx_object_ts_rxmsgts_read(const dspic33_canfd_rx_object_ts_t *element)
{
    const uint16_t part0 = element->R4;
    const uint16_t part1 = element->R5;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_rx_object_ts_rxmsgts_write(dspic33_canfd_rx_object_ts_t *element, uint32_t value)
{
    element->R4 = (uint16_t)((element->R4 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    element->R5 = (uint16_t)((element->R5 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* TEF_OBJECT: Transmit Event FIFO Object.
 * A message that was sent, without its data and without timestamp (TEFTSEN = 0). Unimplemented bits read
 * unknown.
 * Table 7-1; §7.0 p.81
 */
typedef struct {
    volatile uint16_t TE0; /* Standard identifier and low bits of the extended identifier. */
    volatile uint16_t TE1; /* SID11 and high bits of the extended identifier. */
    volatile uint16_t TE2; /* Control bits and low bits of the sequence number, copied from the transmit object. */
    volatile uint16_t TE3; /* High bits of the sequence number. */
} dspic33_canfd_tef_object_t;
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_t, TE0) == 0x000U, dspic33_canfd_tef_object_at_TE0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_t, TE1) == 0x002U, dspic33_canfd_tef_object_at_TE1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_t, TE2) == 0x004U, dspic33_canfd_tef_object_at_TE2);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_t, TE3) == 0x006U, dspic33_canfd_tef_object_at_TE3);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tef_object_t) == 0x008U, dspic33_canfd_tef_object_size);
#define DSPIC33_CANFD_TEF_OBJECT_HEADER_BYTES 8U
/* Word TE0 of TEF_OBJECT: Standard identifier and low bits of the extended identifier.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE0_OFFSET 0x000U
/* EID[4:0]: Extended identifier bits 4 to 0. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Pos 11U
#define DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Msk 0xF800U
#define DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Width 5U
#define DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE0_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Msk))
static inline uint16_t dspic33_canfd_tef_object_te0_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te0_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE0_EID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE0_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Msk 0x07FFU
#define DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Width 11U
#define DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Msk))
static inline uint16_t dspic33_canfd_tef_object_te0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE0_SID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE0_SID_SET(value));
}
/* Word TE1 of TEF_OBJECT: SID11 and high bits of the extended identifier.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE1_OFFSET 0x002U
/* SID11: Least significant bit of a 12-bit standard identifier, the RRS bit of CAN FD base frames with SID11EN.
 * Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Pos 13U
#define DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Msk 0x2000U
#define DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Msk))
static inline uint16_t dspic33_canfd_tef_object_te1_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te1_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE1_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Width 13U
#define DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Msk))
static inline uint16_t dspic33_canfd_tef_object_te1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE1_EID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE1_EID_SET(value));
}
/* Word TE2 of TEF_OBJECT: Control bits and low bits of the sequence number, copied from the transmit object.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_OFFSET 0x004U
/* SEQ[6:0]: Bits 6 to 0 of a number that software chooses to recognize the message in the transmit event FIFO;
 * not sent on the bus. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Pos 9U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Msk 0xFE00U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Width 7U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_seq_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_SEQ_SET(value));
}
/* BRS: Bit rate of the data phase of a CAN FD frame. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Pos 6U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Msk 0x0040U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_brs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_brs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_BRS_SET(value));
}
/* RTR: Remote transmission request; CAN 2.0 frames only. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Pos 5U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Msk 0x0020U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_RTR_SET(value));
}
/* IDE: Identifier format. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Pos 4U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Msk 0x0010U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_IDE_SET(value));
}
/* ESI: ESI; in gateway mode (ESIGM) the flag went out recessive if this bit is set or the controller was error
 * passive. Access rw.
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Pos 8U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Msk 0x0100U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_ESI_SET(value));
}
/* FDF: Frame format. Access rw. */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Pos 7U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Msk 0x0080U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_fdf_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_fdf_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_FDF_SET(value));
}
/* DLC: Data length code of the message. Access rw.
 * Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Msk 0x000FU
#define DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Width 4U
#define DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Msk))
static inline uint16_t dspic33_canfd_tef_object_te2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE2_DLC_SET(value));
}
/* Word TE3 of TEF_OBJECT: High bits of the sequence number.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE3_OFFSET 0x006U
/* SEQ[22:7]: Bits 22 to 7 of the sequence number. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Msk 0xFFFFU
#define DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Width 16U
#define DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Pos) & DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Msk))
static inline uint16_t dspic33_canfd_tef_object_te3_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_te3_seq_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_Msk) | DSPIC33_CANFD_TEF_OBJECT_TE3_SEQ_SET(value));
}
/* EID: Extended identifier, 18 bits. */
static inline uint32_t dspic33_canfd_tef_object_eid_read(const dspic33_canfd_tef_object_t *element)
{
    const uint16_t part0 = element->TE0;
    const uint16_t part1 = element->TE1;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_tef_object_eid_write(dspic33_canfd_tef_object_t *element, uint32_t value)
{
    element->TE0 = (uint16_t)((element->TE0 & (uint16_t)~0xF800U) | (uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U));
    element->TE1 = (uint16_t)((element->TE1 & (uint16_t)~0x1FFFU) | (uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU));
}
/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Register 3-8
 */
static inline uint32_t dspic33_canfd_tef_object_sid12_read(const dspic33_canfd_tef_object_t *element)
{
    const uint16_t part0 = element->TE1;
    const uint16_t part1 = element->TE0;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_tef_object_sid12_write(dspic33_canfd_tef_object_t *element, uint32_t value)
{
    element->TE1 = (uint16_t)((element->TE1 & (uint16_t)~0x2000U) | (uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U));
    element->TE0 = (uint16_t)((element->TE0 & (uint16_t)~0x07FFU) | (uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU));
}
/* SEQ: Sequence number, 23 bits. */
static inline uint32_t dspic33_canfd_tef_object_seq_read(const dspic33_canfd_tef_object_t *element)
{
    const uint16_t part0 = element->TE2;
    const uint16_t part1 = element->TE3;
    return ((uint32_t)((part0 & 0xFE00U) >> 9U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 7U);
}
static inline void dspic33_canfd_tef_object_seq_write(dspic33_canfd_tef_object_t *element, uint32_t value)
{
    element->TE2 = (uint16_t)((element->TE2 & (uint16_t)~0xFE00U) | (uint16_t)(((uint16_t)(value >> 0U) << 9U) & 0xFE00U));
    element->TE3 = (uint16_t)((element->TE3 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 7U) << 0U) & 0xFFFFU));
}

/* TEF_OBJECT_TS: Transmit Event FIFO Object with Timestamp.
 * A message that was sent, with the time of transmission (TEFTSEN = 1).
 * Table 7-1; §7.0 p.81
 */
typedef struct {
    volatile uint16_t TE0; /* Standard identifier and low bits of the extended identifier. */
    volatile uint16_t TE1; /* SID11 and high bits of the extended identifier. */
    volatile uint16_t TE2; /* Control bits and low bits of the sequence number, copied from the transmit object. */
    volatile uint16_t TE3; /* High bits of the sequence number. */
    volatile uint16_t TE4; /* Low half of the timestamp. */
    volatile uint16_t TE5; /* High half of the timestamp. */
} dspic33_canfd_tef_object_ts_t;
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE0) == 0x000U, dspic33_canfd_tef_object_ts_at_TE0);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE1) == 0x002U, dspic33_canfd_tef_object_ts_at_TE1);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE2) == 0x004U, dspic33_canfd_tef_object_ts_at_TE2);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE3) == 0x006U, dspic33_canfd_tef_object_ts_at_TE3);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE4) == 0x008U, dspic33_canfd_tef_object_ts_at_TE4);
DSPIC33_CANFD_STATIC_ASSERT(offsetof(dspic33_canfd_tef_object_ts_t, TE5) == 0x00AU, dspic33_canfd_tef_object_ts_at_TE5);
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tef_object_ts_t) == 0x00CU, dspic33_canfd_tef_object_ts_size);
#define DSPIC33_CANFD_TEF_OBJECT_TS_HEADER_BYTES 12U
/* Word TE0 of TEF_OBJECT_TS: Standard identifier and low bits of the extended identifier.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_OFFSET 0x000U
/* EID[4:0]: Extended identifier bits 4 to 0. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Pos 11U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Msk 0xF800U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Width 5U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te0_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te0_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 31U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE0_EID_SET(value));
}
/* SID: Standard identifier, or the base identifier of an extended one. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Msk 0x07FFU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Width 11U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te0_sid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te0_sid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 2047U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE0_SID_SET(value));
}
/* Word TE1 of TEF_OBJECT_TS: SID11 and high bits of the extended identifier.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_OFFSET 0x002U
/* SID11: Least significant bit of a 12-bit standard identifier, the RRS bit of CAN FD base frames with SID11EN.
 * Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Pos 13U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Msk 0x2000U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te1_sid11_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te1_sid11_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE1_SID11_SET(value));
}
/* EID[17:5]: Extended identifier bits 17 to 5. Access rw.
 * Table 6-1; §6.1; Table 7-1; Table 9-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Msk 0x1FFFU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Width 13U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te1_eid_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te1_eid_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 8191U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE1_EID_SET(value));
}
/* Word TE2 of TEF_OBJECT_TS: Control bits and low bits of the sequence number, copied from the transmit object.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_OFFSET 0x004U
/* SEQ[6:0]: Bits 6 to 0 of a number that software chooses to recognize the message in the transmit event FIFO;
 * not sent on the bus. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Pos 9U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Msk 0xFE00U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Width 7U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_seq_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 127U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_SEQ_SET(value));
}
/* BRS: Bit rate of the data phase of a CAN FD frame. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Pos 6U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Msk 0x0040U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_brs_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_brs_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_BRS_SET(value));
}
/* RTR: Remote transmission request; CAN 2.0 frames only. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Pos 5U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Msk 0x0020U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_rtr_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_rtr_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_RTR_SET(value));
}
/* IDE: Identifier format. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Pos 4U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Msk 0x0010U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_ide_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_ide_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_IDE_SET(value));
}
/* ESI: ESI; in gateway mode (ESIGM) the flag went out recessive if this bit is set or the controller was error
 * passive. Access rw.
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Pos 8U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Msk 0x0100U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_esi_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_esi_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_ESI_SET(value));
}
/* FDF: Frame format. Access rw. */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Pos 7U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Msk 0x0080U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Width 1U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_fdf_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_fdf_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 1U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_FDF_SET(value));
}
/* DLC: Data length code of the message. Access rw.
 * Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Msk 0x000FU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Width 4U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te2_dlc_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te2_dlc_set(uint16_t reg, uint16_t value)
{
    DSPIC33_CANFD_ASSERT(value <= 15U);
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE2_DLC_SET(value));
}
/* Word TE3 of TEF_OBJECT_TS: High bits of the sequence number.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_OFFSET 0x006U
/* SEQ[22:7]: Bits 22 to 7 of the sequence number. Access rw.
 * Table 6-1; §6.1; Table 7-1
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Msk 0xFFFFU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Width 16U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te3_seq_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te3_seq_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE3_SEQ_SET(value));
}
/* Word TE4 of TEF_OBJECT_TS: Low half of the timestamp.
 * Has this layout only if TEFCONL.TEFTSEN.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_OFFSET 0x008U
/* TXMSGTS[15:0]: Bits 15 to 0 of the Time Base Counter at the reference point of the message. Access rw. */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Msk 0xFFFFU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Width 16U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te4_txmsgts_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te4_txmsgts_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE4_TXMSGTS_SET(value));
}
/* Word TE5 of TEF_OBJECT_TS: High half of the timestamp.
 * Has this layout only if TEFCONL.TEFTSEN.
 * Table 7-1; §7.0 p.81
 */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_OFFSET 0x00AU
/* TXMSGTS[31:16]: Bits 31 to 16 of the Time Base Counter at the reference point of the message. Access rw. */
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Pos 0U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Msk 0xFFFFU
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Width 16U
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Access "rw"
#define DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_SET(value) ((uint16_t)(((uint16_t)(value) << DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Pos) & DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Msk))
static inline uint16_t dspic33_canfd_tef_object_ts_te5_txmsgts_get(uint16_t reg)
{
    return (uint16_t)((reg & DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Msk) >> DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Pos);
}
static inline uint16_t dspic33_canfd_tef_object_ts_te5_txmsgts_set(uint16_t reg, uint16_t value)
{
    return (uint16_t)((reg & (uint16_t)~DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_Msk) | DSPIC33_CANFD_TEF_OBJECT_TS_TE5_TXMSGTS_SET(value));
}
/* EID: Extended identifier, 18 bits. */
static inline uint32_t dspic33_canfd_tef_object_ts_eid_read(const dspic33_canfd_tef_object_ts_t *element)
{
    const uint16_t part0 = element->TE0;
    const uint16_t part1 = element->TE1;
    return ((uint32_t)((part0 & 0xF800U) >> 11U) << 0U) | ((uint32_t)((part1 & 0x1FFFU) >> 0U) << 5U);
}
static inline void dspic33_canfd_tef_object_ts_eid_write(dspic33_canfd_tef_object_ts_t *element, uint32_t value)
{
    element->TE0 = (uint16_t)((element->TE0 & (uint16_t)~0xF800U) | (uint16_t)(((uint16_t)(value >> 0U) << 11U) & 0xF800U));
    element->TE1 = (uint16_t)((element->TE1 & (uint16_t)~0x1FFFU) | (uint16_t)(((uint16_t)(value >> 5U) << 0U) & 0x1FFFU));
}
/* SID12: 12-bit standard identifier; SID11 is its least significant bit.
 * Register 3-8
 */
static inline uint32_t dspic33_canfd_tef_object_ts_sid12_read(const dspic33_canfd_tef_object_ts_t *element)
{
    const uint16_t part0 = element->TE1;
    const uint16_t part1 = element->TE0;
    return ((uint32_t)((part0 & 0x2000U) >> 13U) << 0U) | ((uint32_t)((part1 & 0x07FFU) >> 0U) << 1U);
}
static inline void dspic33_canfd_tef_object_ts_sid12_write(dspic33_canfd_tef_object_ts_t *element, uint32_t value)
{
    element->TE1 = (uint16_t)((element->TE1 & (uint16_t)~0x2000U) | (uint16_t)(((uint16_t)(value >> 0U) << 13U) & 0x2000U));
    element->TE0 = (uint16_t)((element->TE0 & (uint16_t)~0x07FFU) | (uint16_t)(((uint16_t)(value >> 1U) << 0U) & 0x07FFU));
}
/* SEQ: Sequence number, 23 bits. */
static inline uint32_t dspic33_canfd_tef_object_ts_seq_read(const dspic33_canfd_tef_object_ts_t *element)
{
    const uint16_t part0 = element->TE2;
    const uint16_t part1 = element->TE3;
    return ((uint32_t)((part0 & 0xFE00U) >> 9U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 7U);
}
static inline void dspic33_canfd_tef_object_ts_seq_write(dspic33_canfd_tef_object_ts_t *element, uint32_t value)
{
    element->TE2 = (uint16_t)((element->TE2 & (uint16_t)~0xFE00U) | (uint16_t)(((uint16_t)(value >> 0U) << 9U) & 0xFE00U));
    element->TE3 = (uint16_t)((element->TE3 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 7U) << 0U) & 0xFFFFU));
}
/* TXMSGTS: Timestamp, 32 bits. */
static inline uint32_t dspic33_canfd_tef_object_ts_txmsgts_read(const dspic33_canfd_tef_object_ts_t *element)
{
    const uint16_t part0 = element->TE4;
    const uint16_t part1 = element->TE5;
    return ((uint32_t)((part0 & 0xFFFFU) >> 0U) << 0U) | ((uint32_t)((part1 & 0xFFFFU) >> 0U) << 16U);
}
static inline void dspic33_canfd_tef_object_ts_txmsgts_write(dspic33_canfd_tef_object_ts_t *element, uint32_t value)
{
    element->TE4 = (uint16_t)((element->TE4 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 0U) << 0U) & 0xFFFFU));
    element->TE5 = (uint16_t)((element->TE5 & (uint16_t)~0xFFFFU) | (uint16_t)(((uint16_t)(value >> 16U) << 0U) & 0xFFFFU));
}

/* The manufacturer's names, such as C1CON and C1CONbits, over the same layout.
 * Define DSPIC33_CANFD_MICROCHIP_NAMES before including this header, and DSPIC33_CANFD_C1_BASE,
 * DSPIC33_CANFD_C2_BASE with the base addresses where no default stands below.
 * Containers have fixed width. A register with flags that a bit-field assignment would clear, or with fields
 * that the read changes, has a const view: clear its flags with the functions above.
 */
#ifdef DSPIC33_CANFD_MICROCHIP_NAMES
#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "bit-fields are laid out for little-endian compilers"
#endif
typedef struct {
    uint16_t DNCNT : 5;
    uint16_t ISOCRCEN : 1;
    uint16_t PXEDIS : 1;
    uint16_t CLKSEL : 1;
    uint16_t WAKFIL : 1;
    uint16_t WFT : 2;
    uint16_t BUSY : 1;
    uint16_t BRSDIS : 1;
    uint16_t SIDL : 1;
    uint16_t : 1;
    uint16_t CON : 1;
} dspic33_canfd_con_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_con_l_bits_t) == 2U, dspic33_canfd_con_l_bits_t_size);
typedef struct {
    uint16_t RTXAT : 1;
    uint16_t ESIGM : 1;
    uint16_t SERRLOM : 1;
    uint16_t STEF : 1;
    uint16_t TXQEN : 1;
    uint16_t OPMOD : 3;
    uint16_t REQOP : 3;
    uint16_t ABAT : 1;
    uint16_t TXBWS : 4;
} dspic33_canfd_con_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_con_h_bits_t) == 2U, dspic33_canfd_con_h_bits_t_size);
typedef struct {
    uint16_t SJW : 7;
    uint16_t : 1;
    uint16_t TSEG2 : 7;
    uint16_t : 1;
} dspic33_canfd_nbtcfg_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_nbtcfg_l_bits_t) == 2U, dspic33_canfd_nbtcfg_l_bits_t_size);
typedef struct {
    uint16_t TSEG1 : 8;
    uint16_t BRP : 8;
} dspic33_canfd_nbtcfg_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_nbtcfg_h_bits_t) == 2U, dspic33_canfd_nbtcfg_h_bits_t_size);
typedef struct {
    uint16_t SJW : 4;
    uint16_t : 4;
    uint16_t TSEG2 : 4;
    uint16_t : 4;
} dspic33_canfd_dbtcfg_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_dbtcfg_l_bits_t) == 2U, dspic33_canfd_dbtcfg_l_bits_t_size);
typedef struct {
    uint16_t TSEG1 : 5;
    uint16_t : 3;
    uint16_t BRP : 8;
} dspic33_canfd_dbtcfg_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_dbtcfg_h_bits_t) == 2U, dspic33_canfd_dbtcfg_h_bits_t_size);
typedef struct {
    uint16_t TDCV : 6;
    uint16_t : 2;
    uint16_t TDCO : 7;
    uint16_t : 1;
} dspic33_canfd_tdc_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tdc_l_bits_t) == 2U, dspic33_canfd_tdc_l_bits_t_size);
typedef struct {
    uint16_t TDCMOD : 2;
    uint16_t : 6;
    uint16_t SID11EN : 1;
    uint16_t EDGFLTEN : 1;
    uint16_t : 6;
} dspic33_canfd_tdc_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tdc_h_bits_t) == 2U, dspic33_canfd_tdc_h_bits_t_size);
typedef struct {
    uint16_t TBC_15_0 : 16;
} dspic33_canfd_tbc_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tbc_l_bits_t) == 2U, dspic33_canfd_tbc_l_bits_t_size);
typedef struct {
    uint16_t TBC_31_16 : 16;
} dspic33_canfd_tbc_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tbc_h_bits_t) == 2U, dspic33_canfd_tbc_h_bits_t_size);
typedef struct {
    uint16_t TBCPRE : 10;
    uint16_t : 6;
} dspic33_canfd_tscon_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tscon_l_bits_t) == 2U, dspic33_canfd_tscon_l_bits_t_size);
typedef struct {
    uint16_t TBCEN : 1;
    uint16_t TSEOF : 1;
    uint16_t TSRES : 1;
    uint16_t : 13;
} dspic33_canfd_tscon_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tscon_h_bits_t) == 2U, dspic33_canfd_tscon_h_bits_t_size);
typedef struct {
    uint16_t ICODE : 7;
    uint16_t : 1;
    uint16_t FILHIT : 5;
    uint16_t : 3;
} dspic33_canfd_vec_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_vec_l_bits_t) == 2U, dspic33_canfd_vec_l_bits_t_size);
typedef struct {
    uint16_t TXCODE : 7;
    uint16_t : 1;
    uint16_t RXCODE : 7;
    uint16_t : 1;
} dspic33_canfd_vec_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_vec_h_bits_t) == 2U, dspic33_canfd_vec_h_bits_t_size);
typedef struct {
    uint16_t TXIF : 1;
    uint16_t RXIF : 1;
    uint16_t TBCIF : 1;
    uint16_t MODIF : 1;
    uint16_t TEFIF : 1;
    uint16_t : 5;
    uint16_t TXATIF : 1;
    uint16_t RXOVIF : 1;
    uint16_t SERRIF : 1;
    uint16_t CERRIF : 1;
    uint16_t WAKIF : 1;
    uint16_t IVMIF : 1;
} dspic33_canfd_int_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_int_l_bits_t) == 2U, dspic33_canfd_int_l_bits_t_size);
typedef struct {
    uint16_t TXIE : 1;
    uint16_t RXIE : 1;
    uint16_t TBCIE : 1;
    uint16_t MODIE : 1;
    uint16_t TEFIE : 1;
    uint16_t : 5;
    uint16_t TXATIE : 1;
    uint16_t RXOVIE : 1;
    uint16_t SERRIE : 1;
    uint16_t CERRIE : 1;
    uint16_t WAKIE : 1;
    uint16_t IVMIE : 1;
} dspic33_canfd_int_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_int_h_bits_t) == 2U, dspic33_canfd_int_h_bits_t_size);
typedef struct {
    uint16_t : 1;
    uint16_t RFIF1 : 1;
    uint16_t RFIF2 : 1;
    uint16_t RFIF3 : 1;
    uint16_t RFIF4 : 1;
    uint16_t RFIF5 : 1;
    uint16_t RFIF6 : 1;
    uint16_t RFIF7 : 1;
    uint16_t RFIF8 : 1;
    uint16_t RFIF9 : 1;
    uint16_t RFIF10 : 1;
    uint16_t RFIF11 : 1;
    uint16_t RFIF12 : 1;
    uint16_t RFIF13 : 1;
    uint16_t RFIF14 : 1;
    uint16_t RFIF15 : 1;
} dspic33_canfd_rxif_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rxif_l_bits_t) == 2U, dspic33_canfd_rxif_l_bits_t_size);
typedef struct {
    uint16_t RFIF16 : 1;
    uint16_t RFIF17 : 1;
    uint16_t RFIF18 : 1;
    uint16_t RFIF19 : 1;
    uint16_t RFIF20 : 1;
    uint16_t RFIF21 : 1;
    uint16_t RFIF22 : 1;
    uint16_t RFIF23 : 1;
    uint16_t RFIF24 : 1;
    uint16_t RFIF25 : 1;
    uint16_t RFIF26 : 1;
    uint16_t RFIF27 : 1;
    uint16_t RFIF28 : 1;
    uint16_t RFIF29 : 1;
    uint16_t RFIF30 : 1;
    uint16_t RFIF31 : 1;
} dspic33_canfd_rxif_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rxif_h_bits_t) == 2U, dspic33_canfd_rxif_h_bits_t_size);
typedef struct {
    uint16_t TFIF0 : 1;
    uint16_t TFIF1 : 1;
    uint16_t TFIF2 : 1;
    uint16_t TFIF3 : 1;
    uint16_t TFIF4 : 1;
    uint16_t TFIF5 : 1;
    uint16_t TFIF6 : 1;
    uint16_t TFIF7 : 1;
    uint16_t TFIF8 : 1;
    uint16_t TFIF9 : 1;
    uint16_t TFIF10 : 1;
    uint16_t TFIF11 : 1;
    uint16_t TFIF12 : 1;
    uint16_t TFIF13 : 1;
    uint16_t TFIF14 : 1;
    uint16_t TFIF15 : 1;
} dspic33_canfd_txif_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txif_l_bits_t) == 2U, dspic33_canfd_txif_l_bits_t_size);
typedef struct {
    uint16_t TFIF16 : 1;
    uint16_t TFIF17 : 1;
    uint16_t TFIF18 : 1;
    uint16_t TFIF19 : 1;
    uint16_t TFIF20 : 1;
    uint16_t TFIF21 : 1;
    uint16_t TFIF22 : 1;
    uint16_t TFIF23 : 1;
    uint16_t TFIF24 : 1;
    uint16_t TFIF25 : 1;
    uint16_t TFIF26 : 1;
    uint16_t TFIF27 : 1;
    uint16_t TFIF28 : 1;
    uint16_t TFIF29 : 1;
    uint16_t TFIF30 : 1;
    uint16_t TFIF31 : 1;
} dspic33_canfd_txif_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txif_h_bits_t) == 2U, dspic33_canfd_txif_h_bits_t_size);
typedef struct {
    uint16_t : 1;
    uint16_t RFOVIF1 : 1;
    uint16_t RFOVIF2 : 1;
    uint16_t RFOVIF3 : 1;
    uint16_t RFOVIF4 : 1;
    uint16_t RFOVIF5 : 1;
    uint16_t RFOVIF6 : 1;
    uint16_t RFOVIF7 : 1;
    uint16_t RFOVIF8 : 1;
    uint16_t RFOVIF9 : 1;
    uint16_t RFOVIF10 : 1;
    uint16_t RFOVIF11 : 1;
    uint16_t RFOVIF12 : 1;
    uint16_t RFOVIF13 : 1;
    uint16_t RFOVIF14 : 1;
    uint16_t RFOVIF15 : 1;
} dspic33_canfd_rxovif_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rxovif_l_bits_t) == 2U, dspic33_canfd_rxovif_l_bits_t_size);
typedef struct {
    uint16_t RFOVIF16 : 1;
    uint16_t RFOVIF17 : 1;
    uint16_t RFOVIF18 : 1;
    uint16_t RFOVIF19 : 1;
    uint16_t RFOVIF20 : 1;
    uint16_t RFOVIF21 : 1;
    uint16_t RFOVIF22 : 1;
    uint16_t RFOVIF23 : 1;
    uint16_t RFOVIF24 : 1;
    uint16_t RFOVIF25 : 1;
    uint16_t RFOVIF26 : 1;
    uint16_t RFOVIF27 : 1;
    uint16_t RFOVIF28 : 1;
    uint16_t RFOVIF29 : 1;
    uint16_t RFOVIF30 : 1;
    uint16_t RFOVIF31 : 1;
} dspic33_canfd_rxovif_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_rxovif_h_bits_t) == 2U, dspic33_canfd_rxovif_h_bits_t_size);
typedef struct {
    uint16_t TFATIF0 : 1;
    uint16_t TFATIF1 : 1;
    uint16_t TFATIF2 : 1;
    uint16_t TFATIF3 : 1;
    uint16_t TFATIF4 : 1;
    uint16_t TFATIF5 : 1;
    uint16_t TFATIF6 : 1;
    uint16_t TFATIF7 : 1;
    uint16_t TFATIF8 : 1;
    uint16_t TFATIF9 : 1;
    uint16_t TFATIF10 : 1;
    uint16_t TFATIF11 : 1;
    uint16_t TFATIF12 : 1;
    uint16_t TFATIF13 : 1;
    uint16_t TFATIF14 : 1;
    uint16_t TFATIF15 : 1;
} dspic33_canfd_txatif_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txatif_l_bits_t) == 2U, dspic33_canfd_txatif_l_bits_t_size);
typedef struct {
    uint16_t TFATIF16 : 1;
    uint16_t TFATIF17 : 1;
    uint16_t TFATIF18 : 1;
    uint16_t TFATIF19 : 1;
    uint16_t TFATIF20 : 1;
    uint16_t TFATIF21 : 1;
    uint16_t TFATIF22 : 1;
    uint16_t TFATIF23 : 1;
    uint16_t TFATIF24 : 1;
    uint16_t TFATIF25 : 1;
    uint16_t TFATIF26 : 1;
    uint16_t TFATIF27 : 1;
    uint16_t TFATIF28 : 1;
    uint16_t TFATIF29 : 1;
    uint16_t TFATIF30 : 1;
    uint16_t TFATIF31 : 1;
} dspic33_canfd_txatif_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txatif_h_bits_t) == 2U, dspic33_canfd_txatif_h_bits_t_size);
typedef struct {
    uint16_t TXREQ0 : 1;
    uint16_t TXREQ1 : 1;
    uint16_t TXREQ2 : 1;
    uint16_t TXREQ3 : 1;
    uint16_t TXREQ4 : 1;
    uint16_t TXREQ5 : 1;
    uint16_t TXREQ6 : 1;
    uint16_t TXREQ7 : 1;
    uint16_t TXREQ8 : 1;
    uint16_t TXREQ9 : 1;
    uint16_t TXREQ10 : 1;
    uint16_t TXREQ11 : 1;
    uint16_t TXREQ12 : 1;
    uint16_t TXREQ13 : 1;
    uint16_t TXREQ14 : 1;
    uint16_t TXREQ15 : 1;
} dspic33_canfd_txreq_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txreq_l_bits_t) == 2U, dspic33_canfd_txreq_l_bits_t_size);
typedef struct {
    uint16_t TXREQ16 : 1;
    uint16_t TXREQ17 : 1;
    uint16_t TXREQ18 : 1;
    uint16_t TXREQ19 : 1;
    uint16_t TXREQ20 : 1;
    uint16_t TXREQ21 : 1;
    uint16_t TXREQ22 : 1;
    uint16_t TXREQ23 : 1;
    uint16_t TXREQ24 : 1;
    uint16_t TXREQ25 : 1;
    uint16_t TXREQ26 : 1;
    uint16_t TXREQ27 : 1;
    uint16_t TXREQ28 : 1;
    uint16_t TXREQ29 : 1;
    uint16_t TXREQ30 : 1;
    uint16_t TXREQ31 : 1;
} dspic33_canfd_txreq_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txreq_h_bits_t) == 2U, dspic33_canfd_txreq_h_bits_t_size);
typedef struct {
    uint16_t RERRCNT : 8;
    uint16_t TERRCNT : 8;
} dspic33_canfd_trec_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_trec_l_bits_t) == 2U, dspic33_canfd_trec_l_bits_t_size);
typedef struct {
    uint16_t EWARN : 1;
    uint16_t RXWARN : 1;
    uint16_t TXWARN : 1;
    uint16_t RXBP : 1;
    uint16_t TXBP : 1;
    uint16_t TXBO : 1;
    uint16_t : 10;
} dspic33_canfd_trec_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_trec_h_bits_t) == 2U, dspic33_canfd_trec_h_bits_t_size);
typedef struct {
    uint16_t NRERRCNT : 8;
    uint16_t NTERRCNT : 8;
} dspic33_canfd_bdiag0_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_bdiag0_l_bits_t) == 2U, dspic33_canfd_bdiag0_l_bits_t_size);
typedef struct {
    uint16_t DRERRCNT : 8;
    uint16_t DTERRCNT : 8;
} dspic33_canfd_bdiag0_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_bdiag0_h_bits_t) == 2U, dspic33_canfd_bdiag0_h_bits_t_size);
typedef struct {
    uint16_t EFMSGCNT : 16;
} dspic33_canfd_bdiag1_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_bdiag1_l_bits_t) == 2U, dspic33_canfd_bdiag1_l_bits_t_size);
typedef struct {
    uint16_t NBIT0ERR : 1;
    uint16_t NBIT1ERR : 1;
    uint16_t NACKERR : 1;
    uint16_t NFORMERR : 1;
    uint16_t NSTUFERR : 1;
    uint16_t NCRCERR : 1;
    uint16_t : 1;
    uint16_t TXBOERR : 1;
    uint16_t DBIT0ERR : 1;
    uint16_t DBIT1ERR : 1;
    uint16_t : 1;
    uint16_t DFORMERR : 1;
    uint16_t DSTUFERR : 1;
    uint16_t DCRCERR : 1;
    uint16_t ESI : 1;
    uint16_t DLCMM : 1;
} dspic33_canfd_bdiag1_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_bdiag1_h_bits_t) == 2U, dspic33_canfd_bdiag1_h_bits_t_size);
typedef struct {
    uint16_t TEFNEIE : 1;
    uint16_t TEFHIE : 1;
    uint16_t TEFFIE : 1;
    uint16_t TEFOVIE : 1;
    uint16_t : 1;
    uint16_t TEFTSEN : 1;
    uint16_t : 2;
    uint16_t UINC : 1;
    uint16_t : 1;
    uint16_t FRESET : 1;
    uint16_t : 5;
} dspic33_canfd_tefcon_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tefcon_l_bits_t) == 2U, dspic33_canfd_tefcon_l_bits_t_size);
typedef struct {
    uint16_t : 8;
    uint16_t FSIZE : 5;
    uint16_t : 3;
} dspic33_canfd_tefcon_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tefcon_h_bits_t) == 2U, dspic33_canfd_tefcon_h_bits_t_size);
typedef struct {
    uint16_t TEFNEIF : 1;
    uint16_t TEFHIF : 1;
    uint16_t TEFFIF : 1;
    uint16_t TEFOVIF : 1;
    uint16_t : 12;
} dspic33_canfd_tefsta_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tefsta_bits_t) == 2U, dspic33_canfd_tefsta_bits_t_size);
typedef struct {
    uint16_t TEFUA_15_0 : 16;
} dspic33_canfd_tefua_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tefua_l_bits_t) == 2U, dspic33_canfd_tefua_l_bits_t_size);
typedef struct {
    uint16_t TEFUA_31_16 : 16;
} dspic33_canfd_tefua_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_tefua_h_bits_t) == 2U, dspic33_canfd_tefua_h_bits_t_size);
typedef struct {
    uint16_t : 2;
    uint16_t FIFOBA_15_2 : 14;
} dspic33_canfd_fifoba_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifoba_l_bits_t) == 2U, dspic33_canfd_fifoba_l_bits_t_size);
typedef struct {
    uint16_t FIFOBA_31_16 : 16;
} dspic33_canfd_fifoba_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifoba_h_bits_t) == 2U, dspic33_canfd_fifoba_h_bits_t_size);
typedef struct {
    uint16_t TXQNIE : 1;
    uint16_t : 1;
    uint16_t TXQEIE : 1;
    uint16_t : 1;
    uint16_t TXATIE : 1;
    uint16_t : 2;
    uint16_t TXEN : 1;
    uint16_t UINC : 1;
    uint16_t TXREQ : 1;
    uint16_t FRESET : 1;
    uint16_t : 5;
} dspic33_canfd_txqcon_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txqcon_l_bits_t) == 2U, dspic33_canfd_txqcon_l_bits_t_size);
typedef struct {
    uint16_t TXPRI : 5;
    uint16_t TXAT : 2;
    uint16_t : 1;
    uint16_t FSIZE : 5;
    uint16_t PLSIZE : 3;
} dspic33_canfd_txqcon_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txqcon_h_bits_t) == 2U, dspic33_canfd_txqcon_h_bits_t_size);
typedef struct {
    uint16_t TXQNIF : 1;
    uint16_t : 1;
    uint16_t TXQEIF : 1;
    uint16_t : 1;
    uint16_t TXATIF : 1;
    uint16_t TXERR : 1;
    uint16_t TXLARB : 1;
    uint16_t TXABT : 1;
    uint16_t TXQCI : 5;
    uint16_t : 3;
} dspic33_canfd_txqsta_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txqsta_bits_t) == 2U, dspic33_canfd_txqsta_bits_t_size);
typedef struct {
    uint16_t TXQUA_15_0 : 16;
} dspic33_canfd_txqua_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txqua_l_bits_t) == 2U, dspic33_canfd_txqua_l_bits_t_size);
typedef struct {
    uint16_t TXQUA_31_16 : 16;
} dspic33_canfd_txqua_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_txqua_h_bits_t) == 2U, dspic33_canfd_txqua_h_bits_t_size);
typedef struct {
    uint16_t TFNRFNIE : 1;
    uint16_t TFHRFHIE : 1;
    uint16_t TFERFFIE : 1;
    uint16_t RXOVIE : 1;
    uint16_t TXATIE : 1;
    uint16_t RXTSEN : 1;
    uint16_t RTREN : 1;
    uint16_t TXEN : 1;
    uint16_t UINC : 1;
    uint16_t TXREQ : 1;
    uint16_t FRESET : 1;
    uint16_t : 5;
} dspic33_canfd_fifo_con_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifo_con_l_bits_t) == 2U, dspic33_canfd_fifo_con_l_bits_t_size);
typedef struct {
    uint16_t TXPRI : 5;
    uint16_t TXAT : 2;
    uint16_t : 1;
    uint16_t FSIZE : 5;
    uint16_t PLSIZE : 3;
} dspic33_canfd_fifo_con_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifo_con_h_bits_t) == 2U, dspic33_canfd_fifo_con_h_bits_t_size);
typedef struct {
    uint16_t TFNRFNIF : 1;
    uint16_t TFHRFHIF : 1;
    uint16_t TFERFFIF : 1;
    uint16_t RXOVIF : 1;
    uint16_t TXATIF : 1;
    uint16_t TXERR : 1;
    uint16_t TXLARB : 1;
    uint16_t TXABT : 1;
    uint16_t FIFOCI : 5;
    uint16_t : 3;
} dspic33_canfd_fifo_sta_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifo_sta_bits_t) == 2U, dspic33_canfd_fifo_sta_bits_t_size);
typedef struct {
    uint16_t FIFOUA_15_0 : 16;
} dspic33_canfd_fifo_ua_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifo_ua_l_bits_t) == 2U, dspic33_canfd_fifo_ua_l_bits_t_size);
typedef struct {
    uint16_t FIFOUA_31_16 : 16;
} dspic33_canfd_fifo_ua_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fifo_ua_h_bits_t) == 2U, dspic33_canfd_fifo_ua_h_bits_t_size);
typedef struct {
    uint16_t F0BP : 5;
    uint16_t : 2;
    uint16_t FLTEN0 : 1;
    uint16_t F1BP : 5;
    uint16_t : 2;
    uint16_t FLTEN1 : 1;
} dspic33_canfd_fltcon0l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon0l_bits_t) == 2U, dspic33_canfd_fltcon0l_bits_t_size);
typedef struct {
    uint16_t F2BP : 5;
    uint16_t : 2;
    uint16_t FLTEN2 : 1;
    uint16_t F3BP : 5;
    uint16_t : 2;
    uint16_t FLTEN3 : 1;
} dspic33_canfd_fltcon0h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon0h_bits_t) == 2U, dspic33_canfd_fltcon0h_bits_t_size);
typedef struct {
    uint16_t F4BP : 5;
    uint16_t : 2;
    uint16_t FLTEN4 : 1;
    uint16_t F5BP : 5;
    uint16_t : 2;
    uint16_t FLTEN5 : 1;
} dspic33_canfd_fltcon1l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon1l_bits_t) == 2U, dspic33_canfd_fltcon1l_bits_t_size);
typedef struct {
    uint16_t F6BP : 5;
    uint16_t : 2;
    uint16_t FLTEN6 : 1;
    uint16_t F7BP : 5;
    uint16_t : 2;
    uint16_t FLTEN7 : 1;
} dspic33_canfd_fltcon1h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon1h_bits_t) == 2U, dspic33_canfd_fltcon1h_bits_t_size);
typedef struct {
    uint16_t F8BP : 5;
    uint16_t : 2;
    uint16_t FLTEN8 : 1;
    uint16_t F9BP : 5;
    uint16_t : 2;
    uint16_t FLTEN9 : 1;
} dspic33_canfd_fltcon2l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon2l_bits_t) == 2U, dspic33_canfd_fltcon2l_bits_t_size);
typedef struct {
    uint16_t F10BP : 5;
    uint16_t : 2;
    uint16_t FLTEN10 : 1;
    uint16_t F11BP : 5;
    uint16_t : 2;
    uint16_t FLTEN11 : 1;
} dspic33_canfd_fltcon2h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon2h_bits_t) == 2U, dspic33_canfd_fltcon2h_bits_t_size);
typedef struct {
    uint16_t F12BP : 5;
    uint16_t : 2;
    uint16_t FLTEN12 : 1;
    uint16_t F13BP : 5;
    uint16_t : 2;
    uint16_t FLTEN13 : 1;
} dspic33_canfd_fltcon3l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon3l_bits_t) == 2U, dspic33_canfd_fltcon3l_bits_t_size);
typedef struct {
    uint16_t F14BP : 5;
    uint16_t : 2;
    uint16_t FLTEN14 : 1;
    uint16_t F15BP : 5;
    uint16_t : 2;
    uint16_t FLTEN15 : 1;
} dspic33_canfd_fltcon3h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon3h_bits_t) == 2U, dspic33_canfd_fltcon3h_bits_t_size);
typedef struct {
    uint16_t F16BP : 5;
    uint16_t : 2;
    uint16_t FLTEN16 : 1;
    uint16_t F17BP : 5;
    uint16_t : 2;
    uint16_t FLTEN17 : 1;
} dspic33_canfd_fltcon4l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon4l_bits_t) == 2U, dspic33_canfd_fltcon4l_bits_t_size);
typedef struct {
    uint16_t F18BP : 5;
    uint16_t : 2;
    uint16_t FLTEN18 : 1;
    uint16_t F19BP : 5;
    uint16_t : 2;
    uint16_t FLTEN19 : 1;
} dspic33_canfd_fltcon4h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon4h_bits_t) == 2U, dspic33_canfd_fltcon4h_bits_t_size);
typedef struct {
    uint16_t F20BP : 5;
    uint16_t : 2;
    uint16_t FLTEN20 : 1;
    uint16_t F21BP : 5;
    uint16_t : 2;
    uint16_t FLTEN21 : 1;
} dspic33_canfd_fltcon5l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon5l_bits_t) == 2U, dspic33_canfd_fltcon5l_bits_t_size);
typedef struct {
    uint16_t F22BP : 5;
    uint16_t : 2;
    uint16_t FLTEN22 : 1;
    uint16_t F23BP : 5;
    uint16_t : 2;
    uint16_t FLTEN23 : 1;
} dspic33_canfd_fltcon5h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon5h_bits_t) == 2U, dspic33_canfd_fltcon5h_bits_t_size);
typedef struct {
    uint16_t F24BP : 5;
    uint16_t : 2;
    uint16_t FLTEN24 : 1;
    uint16_t F25BP : 5;
    uint16_t : 2;
    uint16_t FLTEN25 : 1;
} dspic33_canfd_fltcon6l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon6l_bits_t) == 2U, dspic33_canfd_fltcon6l_bits_t_size);
typedef struct {
    uint16_t F26BP : 5;
    uint16_t : 2;
    uint16_t FLTEN26 : 1;
    uint16_t F27BP : 5;
    uint16_t : 2;
    uint16_t FLTEN27 : 1;
} dspic33_canfd_fltcon6h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon6h_bits_t) == 2U, dspic33_canfd_fltcon6h_bits_t_size);
typedef struct {
    uint16_t F28BP : 5;
    uint16_t : 2;
    uint16_t FLTEN28 : 1;
    uint16_t F29BP : 5;
    uint16_t : 2;
    uint16_t FLTEN29 : 1;
} dspic33_canfd_fltcon7l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon7l_bits_t) == 2U, dspic33_canfd_fltcon7l_bits_t_size);
typedef struct {
    uint16_t F30BP : 5;
    uint16_t : 2;
    uint16_t FLTEN30 : 1;
    uint16_t F31BP : 5;
    uint16_t : 2;
    uint16_t FLTEN31 : 1;
} dspic33_canfd_fltcon7h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_fltcon7h_bits_t) == 2U, dspic33_canfd_fltcon7h_bits_t_size);
typedef struct {
    uint16_t SID : 11;
    uint16_t EID_4_0 : 5;
} dspic33_canfd_flt_obj_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_flt_obj_l_bits_t) == 2U, dspic33_canfd_flt_obj_l_bits_t_size);
typedef struct {
    uint16_t EID_17_5 : 13;
    uint16_t SID11 : 1;
    uint16_t EXIDE : 1;
    uint16_t : 1;
} dspic33_canfd_flt_obj_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_flt_obj_h_bits_t) == 2U, dspic33_canfd_flt_obj_h_bits_t_size);
typedef struct {
    uint16_t MSID : 11;
    uint16_t MEID_4_0 : 5;
} dspic33_canfd_mask_l_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_mask_l_bits_t) == 2U, dspic33_canfd_mask_l_bits_t_size);
typedef struct {
    uint16_t MEID_17_5 : 13;
    uint16_t MSID11 : 1;
    uint16_t MIDE : 1;
    uint16_t : 1;
} dspic33_canfd_mask_h_bits_t;
DSPIC33_CANFD_STATIC_ASSERT(sizeof(dspic33_canfd_mask_h_bits_t) == 2U, dspic33_canfd_mask_h_bits_t_size);
#ifdef DSPIC33_CANFD_C1_BASE
#define C1CONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x000U))
#define C1CONLbits (*(volatile dspic33_canfd_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x000U))
#define C1CONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x002U))
#define C1CONHbits (*(volatile dspic33_canfd_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x002U))
#define C1NBTCFGL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x004U))
#define C1NBTCFGLbits (*(volatile dspic33_canfd_nbtcfg_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x004U))
#define C1NBTCFGH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x006U))
#define C1NBTCFGHbits (*(volatile dspic33_canfd_nbtcfg_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x006U))
#define C1DBTCFGL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x008U))
#define C1DBTCFGLbits (*(volatile dspic33_canfd_dbtcfg_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x008U))
#define C1DBTCFGH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00AU))
#define C1DBTCFGHbits (*(volatile dspic33_canfd_dbtcfg_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00AU))
#define C1TDCL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00CU))
#define C1TDCLbits (*(volatile dspic33_canfd_tdc_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00CU))
#define C1TDCH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00EU))
#define C1TDCHbits (*(volatile dspic33_canfd_tdc_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x00EU))
#define C1TBCL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x010U))
#define C1TBCLbits (*(const volatile dspic33_canfd_tbc_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x010U))
#define C1TBCH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x012U))
#define C1TBCHbits (*(const volatile dspic33_canfd_tbc_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x012U))
#define C1TSCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x014U))
#define C1TSCONLbits (*(volatile dspic33_canfd_tscon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x014U))
#define C1TSCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x016U))
#define C1TSCONHbits (*(volatile dspic33_canfd_tscon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x016U))
#define C1VECL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x018U))
#define C1VECLbits (*(const volatile dspic33_canfd_vec_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x018U))
#define C1VECH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01AU))
#define C1VECHbits (*(const volatile dspic33_canfd_vec_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01AU))
#define C1INTL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01CU))
#define C1INTLbits (*(const volatile dspic33_canfd_int_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01CU))
#define C1INTH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01EU))
#define C1INTHbits (*(volatile dspic33_canfd_int_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x01EU))
#define C1RXIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x020U))
#define C1RXIFLbits (*(const volatile dspic33_canfd_rxif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x020U))
#define C1RXIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x022U))
#define C1RXIFHbits (*(const volatile dspic33_canfd_rxif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x022U))
#define C1TXIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x024U))
#define C1TXIFLbits (*(const volatile dspic33_canfd_txif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x024U))
#define C1TXIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x026U))
#define C1TXIFHbits (*(const volatile dspic33_canfd_txif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x026U))
#define C1RXOVIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x028U))
#define C1RXOVIFLbits (*(const volatile dspic33_canfd_rxovif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x028U))
#define C1RXOVIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02AU))
#define C1RXOVIFHbits (*(const volatile dspic33_canfd_rxovif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02AU))
#define C1TXATIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02CU))
#define C1TXATIFLbits (*(const volatile dspic33_canfd_txatif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02CU))
#define C1TXATIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02EU))
#define C1TXATIFHbits (*(const volatile dspic33_canfd_txatif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x02EU))
#define C1TXREQL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x030U))
#define C1TXREQLbits (*(const volatile dspic33_canfd_txreq_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x030U))
#define C1TXREQH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x032U))
#define C1TXREQHbits (*(const volatile dspic33_canfd_txreq_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x032U))
#define C1TRECL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x034U))
#define C1TRECLbits (*(const volatile dspic33_canfd_trec_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x034U))
#define C1TRECH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x036U))
#define C1TRECHbits (*(const volatile dspic33_canfd_trec_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x036U))
#define C1BDIAG0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x038U))
#define C1BDIAG0Lbits (*(const volatile dspic33_canfd_bdiag0_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x038U))
#define C1BDIAG0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03AU))
#define C1BDIAG0Hbits (*(const volatile dspic33_canfd_bdiag0_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03AU))
#define C1BDIAG1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03CU))
#define C1BDIAG1Lbits (*(const volatile dspic33_canfd_bdiag1_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03CU))
#define C1BDIAG1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03EU))
#define C1BDIAG1Hbits (*(const volatile dspic33_canfd_bdiag1_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x03EU))
#define C1TEFCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x040U))
#define C1TEFCONLbits (*(volatile dspic33_canfd_tefcon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x040U))
#define C1TEFCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x042U))
#define C1TEFCONHbits (*(volatile dspic33_canfd_tefcon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x042U))
#define C1TEFSTA (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x044U))
#define C1TEFSTAbits (*(const volatile dspic33_canfd_tefsta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x044U))
#define C1TEFUAL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x048U))
#define C1TEFUALbits (*(const volatile dspic33_canfd_tefua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x048U))
#define C1TEFUAH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04AU))
#define C1TEFUAHbits (*(const volatile dspic33_canfd_tefua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04AU))
#define C1FIFOBAL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04CU))
#define C1FIFOBALbits (*(volatile dspic33_canfd_fifoba_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04CU))
#define C1FIFOBAH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04EU))
#define C1FIFOBAHbits (*(volatile dspic33_canfd_fifoba_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x04EU))
#define C1TXQCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x050U))
#define C1TXQCONLbits (*(volatile dspic33_canfd_txqcon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x050U))
#define C1TXQCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x052U))
#define C1TXQCONHbits (*(volatile dspic33_canfd_txqcon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x052U))
#define C1TXQSTA (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x054U))
#define C1TXQSTAbits (*(const volatile dspic33_canfd_txqsta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x054U))
#define C1TXQUAL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x058U))
#define C1TXQUALbits (*(const volatile dspic33_canfd_txqua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x058U))
#define C1TXQUAH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05AU))
#define C1TXQUAHbits (*(const volatile dspic33_canfd_txqua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05AU))
#define C1FIFOCON1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05CU))
#define C1FIFOCON1Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05CU))
#define C1FIFOCON1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05EU))
#define C1FIFOCON1Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x05EU))
#define C1FIFOSTA1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x060U))
#define C1FIFOSTA1bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x060U))
#define C1FIFOUA1L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x064U))
#define C1FIFOUA1Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x064U))
#define C1FIFOUA1H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x066U))
#define C1FIFOUA1Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x066U))
#define C1FIFOCON2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x068U))
#define C1FIFOCON2Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x068U))
#define C1FIFOCON2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x06AU))
#define C1FIFOCON2Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x06AU))
#define C1FIFOSTA2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x06CU))
#define C1FIFOSTA2bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x06CU))
#define C1FIFOUA2L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x070U))
#define C1FIFOUA2Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x070U))
#define C1FIFOUA2H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x072U))
#define C1FIFOUA2Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x072U))
#define C1FIFOCON3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x074U))
#define C1FIFOCON3Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x074U))
#define C1FIFOCON3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x076U))
#define C1FIFOCON3Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x076U))
#define C1FIFOSTA3 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x078U))
#define C1FIFOSTA3bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x078U))
#define C1FIFOUA3L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x07CU))
#define C1FIFOUA3Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x07CU))
#define C1FIFOUA3H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x07EU))
#define C1FIFOUA3Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x07EU))
#define C1FIFOCON4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x080U))
#define C1FIFOCON4Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x080U))
#define C1FIFOCON4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x082U))
#define C1FIFOCON4Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x082U))
#define C1FIFOSTA4 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x084U))
#define C1FIFOSTA4bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x084U))
#define C1FIFOUA4L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x088U))
#define C1FIFOUA4Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x088U))
#define C1FIFOUA4H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08AU))
#define C1FIFOUA4Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08AU))
#define C1FIFOCON5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08CU))
#define C1FIFOCON5Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08CU))
#define C1FIFOCON5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08EU))
#define C1FIFOCON5Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x08EU))
#define C1FIFOSTA5 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x090U))
#define C1FIFOSTA5bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x090U))
#define C1FIFOUA5L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x094U))
#define C1FIFOUA5Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x094U))
#define C1FIFOUA5H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x096U))
#define C1FIFOUA5Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x096U))
#define C1FIFOCON6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x098U))
#define C1FIFOCON6Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x098U))
#define C1FIFOCON6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x09AU))
#define C1FIFOCON6Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x09AU))
#define C1FIFOSTA6 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x09CU))
#define C1FIFOSTA6bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x09CU))
#define C1FIFOUA6L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A0U))
#define C1FIFOUA6Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A0U))
#define C1FIFOUA6H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A2U))
#define C1FIFOUA6Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A2U))
#define C1FIFOCON7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A4U))
#define C1FIFOCON7Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A4U))
#define C1FIFOCON7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A6U))
#define C1FIFOCON7Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A6U))
#define C1FIFOSTA7 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A8U))
#define C1FIFOSTA7bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0A8U))
#define C1FIFOUA7L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0ACU))
#define C1FIFOUA7Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0ACU))
#define C1FIFOUA7H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0AEU))
#define C1FIFOUA7Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0AEU))
#define C1FIFOCON8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B0U))
#define C1FIFOCON8Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B0U))
#define C1FIFOCON8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B2U))
#define C1FIFOCON8Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B2U))
#define C1FIFOSTA8 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B4U))
#define C1FIFOSTA8bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B4U))
#define C1FIFOUA8L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B8U))
#define C1FIFOUA8Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0B8U))
#define C1FIFOUA8H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BAU))
#define C1FIFOUA8Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BAU))
#define C1FIFOCON9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BCU))
#define C1FIFOCON9Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BCU))
#define C1FIFOCON9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BEU))
#define C1FIFOCON9Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0BEU))
#define C1FIFOSTA9 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C0U))
#define C1FIFOSTA9bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C0U))
#define C1FIFOUA9L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C4U))
#define C1FIFOUA9Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C4U))
#define C1FIFOUA9H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C6U))
#define C1FIFOUA9Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C6U))
#define C1FIFOCON10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C8U))
#define C1FIFOCON10Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0C8U))
#define C1FIFOCON10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0CAU))
#define C1FIFOCON10Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0CAU))
#define C1FIFOSTA10 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0CCU))
#define C1FIFOSTA10bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0CCU))
#define C1FIFOUA10L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D0U))
#define C1FIFOUA10Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D0U))
#define C1FIFOUA10H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D2U))
#define C1FIFOUA10Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D2U))
#define C1FIFOCON11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D4U))
#define C1FIFOCON11Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D4U))
#define C1FIFOCON11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D6U))
#define C1FIFOCON11Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D6U))
#define C1FIFOSTA11 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D8U))
#define C1FIFOSTA11bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0D8U))
#define C1FIFOUA11L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0DCU))
#define C1FIFOUA11Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0DCU))
#define C1FIFOUA11H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0DEU))
#define C1FIFOUA11Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0DEU))
#define C1FIFOCON12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E0U))
#define C1FIFOCON12Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E0U))
#define C1FIFOCON12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E2U))
#define C1FIFOCON12Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E2U))
#define C1FIFOSTA12 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E4U))
#define C1FIFOSTA12bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E4U))
#define C1FIFOUA12L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E8U))
#define C1FIFOUA12Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0E8U))
#define C1FIFOUA12H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0EAU))
#define C1FIFOUA12Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0EAU))
#define C1FIFOCON13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0ECU))
#define C1FIFOCON13Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0ECU))
#define C1FIFOCON13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0EEU))
#define C1FIFOCON13Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0EEU))
#define C1FIFOSTA13 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F0U))
#define C1FIFOSTA13bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F0U))
#define C1FIFOUA13L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F4U))
#define C1FIFOUA13Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F4U))
#define C1FIFOUA13H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F6U))
#define C1FIFOUA13Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F6U))
#define C1FIFOCON14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F8U))
#define C1FIFOCON14Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0F8U))
#define C1FIFOCON14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0FAU))
#define C1FIFOCON14Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0FAU))
#define C1FIFOSTA14 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0FCU))
#define C1FIFOSTA14bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x0FCU))
#define C1FIFOUA14L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x100U))
#define C1FIFOUA14Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x100U))
#define C1FIFOUA14H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x102U))
#define C1FIFOUA14Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x102U))
#define C1FIFOCON15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x104U))
#define C1FIFOCON15Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x104U))
#define C1FIFOCON15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x106U))
#define C1FIFOCON15Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x106U))
#define C1FIFOSTA15 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x108U))
#define C1FIFOSTA15bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x108U))
#define C1FIFOUA15L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x10CU))
#define C1FIFOUA15Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x10CU))
#define C1FIFOUA15H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x10EU))
#define C1FIFOUA15Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x10EU))
#define C1FIFOCON16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x110U))
#define C1FIFOCON16Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x110U))
#define C1FIFOCON16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x112U))
#define C1FIFOCON16Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x112U))
#define C1FIFOSTA16 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x114U))
#define C1FIFOSTA16bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x114U))
#define C1FIFOUA16L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x118U))
#define C1FIFOUA16Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x118U))
#define C1FIFOUA16H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11AU))
#define C1FIFOUA16Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11AU))
#define C1FIFOCON17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11CU))
#define C1FIFOCON17Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11CU))
#define C1FIFOCON17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11EU))
#define C1FIFOCON17Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x11EU))
#define C1FIFOSTA17 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x120U))
#define C1FIFOSTA17bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x120U))
#define C1FIFOUA17L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x124U))
#define C1FIFOUA17Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x124U))
#define C1FIFOUA17H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x126U))
#define C1FIFOUA17Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x126U))
#define C1FIFOCON18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x128U))
#define C1FIFOCON18Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x128U))
#define C1FIFOCON18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x12AU))
#define C1FIFOCON18Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x12AU))
#define C1FIFOSTA18 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x12CU))
#define C1FIFOSTA18bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x12CU))
#define C1FIFOUA18L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x130U))
#define C1FIFOUA18Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x130U))
#define C1FIFOUA18H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x132U))
#define C1FIFOUA18Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x132U))
#define C1FIFOCON19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x134U))
#define C1FIFOCON19Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x134U))
#define C1FIFOCON19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x136U))
#define C1FIFOCON19Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x136U))
#define C1FIFOSTA19 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x138U))
#define C1FIFOSTA19bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x138U))
#define C1FIFOUA19L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x13CU))
#define C1FIFOUA19Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x13CU))
#define C1FIFOUA19H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x13EU))
#define C1FIFOUA19Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x13EU))
#define C1FIFOCON20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x140U))
#define C1FIFOCON20Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x140U))
#define C1FIFOCON20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x142U))
#define C1FIFOCON20Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x142U))
#define C1FIFOSTA20 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x144U))
#define C1FIFOSTA20bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x144U))
#define C1FIFOUA20L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x148U))
#define C1FIFOUA20Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x148U))
#define C1FIFOUA20H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14AU))
#define C1FIFOUA20Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14AU))
#define C1FIFOCON21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14CU))
#define C1FIFOCON21Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14CU))
#define C1FIFOCON21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14EU))
#define C1FIFOCON21Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x14EU))
#define C1FIFOSTA21 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x150U))
#define C1FIFOSTA21bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x150U))
#define C1FIFOUA21L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x154U))
#define C1FIFOUA21Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x154U))
#define C1FIFOUA21H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x156U))
#define C1FIFOUA21Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x156U))
#define C1FIFOCON22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x158U))
#define C1FIFOCON22Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x158U))
#define C1FIFOCON22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x15AU))
#define C1FIFOCON22Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x15AU))
#define C1FIFOSTA22 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x15CU))
#define C1FIFOSTA22bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x15CU))
#define C1FIFOUA22L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x160U))
#define C1FIFOUA22Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x160U))
#define C1FIFOUA22H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x162U))
#define C1FIFOUA22Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x162U))
#define C1FIFOCON23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x164U))
#define C1FIFOCON23Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x164U))
#define C1FIFOCON23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x166U))
#define C1FIFOCON23Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x166U))
#define C1FIFOSTA23 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x168U))
#define C1FIFOSTA23bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x168U))
#define C1FIFOUA23L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x16CU))
#define C1FIFOUA23Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x16CU))
#define C1FIFOUA23H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x16EU))
#define C1FIFOUA23Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x16EU))
#define C1FIFOCON24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x170U))
#define C1FIFOCON24Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x170U))
#define C1FIFOCON24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x172U))
#define C1FIFOCON24Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x172U))
#define C1FIFOSTA24 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x174U))
#define C1FIFOSTA24bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x174U))
#define C1FIFOUA24L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x178U))
#define C1FIFOUA24Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x178U))
#define C1FIFOUA24H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17AU))
#define C1FIFOUA24Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17AU))
#define C1FIFOCON25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17CU))
#define C1FIFOCON25Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17CU))
#define C1FIFOCON25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17EU))
#define C1FIFOCON25Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x17EU))
#define C1FIFOSTA25 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x180U))
#define C1FIFOSTA25bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x180U))
#define C1FIFOUA25L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x184U))
#define C1FIFOUA25Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x184U))
#define C1FIFOUA25H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x186U))
#define C1FIFOUA25Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x186U))
#define C1FIFOCON26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x188U))
#define C1FIFOCON26Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x188U))
#define C1FIFOCON26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x18AU))
#define C1FIFOCON26Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x18AU))
#define C1FIFOSTA26 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x18CU))
#define C1FIFOSTA26bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x18CU))
#define C1FIFOUA26L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x190U))
#define C1FIFOUA26Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x190U))
#define C1FIFOUA26H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x192U))
#define C1FIFOUA26Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x192U))
#define C1FIFOCON27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x194U))
#define C1FIFOCON27Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x194U))
#define C1FIFOCON27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x196U))
#define C1FIFOCON27Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x196U))
#define C1FIFOSTA27 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x198U))
#define C1FIFOSTA27bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x198U))
#define C1FIFOUA27L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x19CU))
#define C1FIFOUA27Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x19CU))
#define C1FIFOUA27H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x19EU))
#define C1FIFOUA27Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x19EU))
#define C1FIFOCON28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A0U))
#define C1FIFOCON28Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A0U))
#define C1FIFOCON28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A2U))
#define C1FIFOCON28Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A2U))
#define C1FIFOSTA28 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A4U))
#define C1FIFOSTA28bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A4U))
#define C1FIFOUA28L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A8U))
#define C1FIFOUA28Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1A8U))
#define C1FIFOUA28H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1AAU))
#define C1FIFOUA28Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1AAU))
#define C1FIFOCON29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1ACU))
#define C1FIFOCON29Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1ACU))
#define C1FIFOCON29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1AEU))
#define C1FIFOCON29Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1AEU))
#define C1FIFOSTA29 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B0U))
#define C1FIFOSTA29bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B0U))
#define C1FIFOUA29L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B4U))
#define C1FIFOUA29Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B4U))
#define C1FIFOUA29H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B6U))
#define C1FIFOUA29Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B6U))
#define C1FIFOCON30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B8U))
#define C1FIFOCON30Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1B8U))
#define C1FIFOCON30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1BAU))
#define C1FIFOCON30Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1BAU))
#define C1FIFOSTA30 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1BCU))
#define C1FIFOSTA30bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1BCU))
#define C1FIFOUA30L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C0U))
#define C1FIFOUA30Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C0U))
#define C1FIFOUA30H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C2U))
#define C1FIFOUA30Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C2U))
#define C1FIFOCON31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C4U))
#define C1FIFOCON31Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C4U))
#define C1FIFOCON31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C6U))
#define C1FIFOCON31Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C6U))
#define C1FIFOSTA31 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C8U))
#define C1FIFOSTA31bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1C8U))
#define C1FIFOUA31L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1CCU))
#define C1FIFOUA31Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1CCU))
#define C1FIFOUA31H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1CEU))
#define C1FIFOUA31Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1CEU))
#define C1FLTCON0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D0U))
#define C1FLTCON0Lbits (*(volatile dspic33_canfd_fltcon0l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D0U))
#define C1FLTCON0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D2U))
#define C1FLTCON0Hbits (*(volatile dspic33_canfd_fltcon0h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D2U))
#define C1FLTCON1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D4U))
#define C1FLTCON1Lbits (*(volatile dspic33_canfd_fltcon1l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D4U))
#define C1FLTCON1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D6U))
#define C1FLTCON1Hbits (*(volatile dspic33_canfd_fltcon1h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D6U))
#define C1FLTCON2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D8U))
#define C1FLTCON2Lbits (*(volatile dspic33_canfd_fltcon2l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1D8U))
#define C1FLTCON2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DAU))
#define C1FLTCON2Hbits (*(volatile dspic33_canfd_fltcon2h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DAU))
#define C1FLTCON3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DCU))
#define C1FLTCON3Lbits (*(volatile dspic33_canfd_fltcon3l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DCU))
#define C1FLTCON3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DEU))
#define C1FLTCON3Hbits (*(volatile dspic33_canfd_fltcon3h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1DEU))
#define C1FLTCON4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E0U))
#define C1FLTCON4Lbits (*(volatile dspic33_canfd_fltcon4l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E0U))
#define C1FLTCON4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E2U))
#define C1FLTCON4Hbits (*(volatile dspic33_canfd_fltcon4h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E2U))
#define C1FLTCON5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E4U))
#define C1FLTCON5Lbits (*(volatile dspic33_canfd_fltcon5l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E4U))
#define C1FLTCON5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E6U))
#define C1FLTCON5Hbits (*(volatile dspic33_canfd_fltcon5h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E6U))
#define C1FLTCON6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E8U))
#define C1FLTCON6Lbits (*(volatile dspic33_canfd_fltcon6l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1E8U))
#define C1FLTCON6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1EAU))
#define C1FLTCON6Hbits (*(volatile dspic33_canfd_fltcon6h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1EAU))
#define C1FLTCON7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1ECU))
#define C1FLTCON7Lbits (*(volatile dspic33_canfd_fltcon7l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1ECU))
#define C1FLTCON7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1EEU))
#define C1FLTCON7Hbits (*(volatile dspic33_canfd_fltcon7h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1EEU))
#define C1FLTOBJ0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F0U))
#define C1FLTOBJ0Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F0U))
#define C1FLTOBJ0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F2U))
#define C1FLTOBJ0Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F2U))
#define C1MASK0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F4U))
#define C1MASK0Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F4U))
#define C1MASK0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F6U))
#define C1MASK0Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F6U))
#define C1FLTOBJ1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F8U))
#define C1FLTOBJ1Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1F8U))
#define C1FLTOBJ1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FAU))
#define C1FLTOBJ1Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FAU))
#define C1MASK1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FCU))
#define C1MASK1Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FCU))
#define C1MASK1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FEU))
#define C1MASK1Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x1FEU))
#define C1FLTOBJ2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x200U))
#define C1FLTOBJ2Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x200U))
#define C1FLTOBJ2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x202U))
#define C1FLTOBJ2Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x202U))
#define C1MASK2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x204U))
#define C1MASK2Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x204U))
#define C1MASK2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x206U))
#define C1MASK2Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x206U))
#define C1FLTOBJ3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x208U))
#define C1FLTOBJ3Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x208U))
#define C1FLTOBJ3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20AU))
#define C1FLTOBJ3Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20AU))
#define C1MASK3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20CU))
#define C1MASK3Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20CU))
#define C1MASK3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20EU))
#define C1MASK3Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x20EU))
#define C1FLTOBJ4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x210U))
#define C1FLTOBJ4Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x210U))
#define C1FLTOBJ4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x212U))
#define C1FLTOBJ4Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x212U))
#define C1MASK4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x214U))
#define C1MASK4Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x214U))
#define C1MASK4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x216U))
#define C1MASK4Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x216U))
#define C1FLTOBJ5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x218U))
#define C1FLTOBJ5Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x218U))
#define C1FLTOBJ5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21AU))
#define C1FLTOBJ5Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21AU))
#define C1MASK5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21CU))
#define C1MASK5Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21CU))
#define C1MASK5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21EU))
#define C1MASK5Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x21EU))
#define C1FLTOBJ6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x220U))
#define C1FLTOBJ6Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x220U))
#define C1FLTOBJ6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x222U))
#define C1FLTOBJ6Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x222U))
#define C1MASK6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x224U))
#define C1MASK6Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x224U))
#define C1MASK6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x226U))
#define C1MASK6Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x226U))
#define C1FLTOBJ7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x228U))
#define C1FLTOBJ7Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x228U))
#define C1FLTOBJ7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22AU))
#define C1FLTOBJ7Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22AU))
#define C1MASK7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22CU))
#define C1MASK7Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22CU))
#define C1MASK7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22EU))
#define C1MASK7Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x22EU))
#define C1FLTOBJ8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x230U))
#define C1FLTOBJ8Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x230U))
#define C1FLTOBJ8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x232U))
#define C1FLTOBJ8Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x232U))
#define C1MASK8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x234U))
#define C1MASK8Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x234U))
#define C1MASK8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x236U))
#define C1MASK8Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x236U))
#define C1FLTOBJ9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x238U))
#define C1FLTOBJ9Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x238U))
#define C1FLTOBJ9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23AU))
#define C1FLTOBJ9Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23AU))
#define C1MASK9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23CU))
#define C1MASK9Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23CU))
#define C1MASK9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23EU))
#define C1MASK9Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x23EU))
#define C1FLTOBJ10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x240U))
#define C1FLTOBJ10Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x240U))
#define C1FLTOBJ10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x242U))
#define C1FLTOBJ10Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x242U))
#define C1MASK10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x244U))
#define C1MASK10Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x244U))
#define C1MASK10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x246U))
#define C1MASK10Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x246U))
#define C1FLTOBJ11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x248U))
#define C1FLTOBJ11Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x248U))
#define C1FLTOBJ11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24AU))
#define C1FLTOBJ11Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24AU))
#define C1MASK11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24CU))
#define C1MASK11Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24CU))
#define C1MASK11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24EU))
#define C1MASK11Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x24EU))
#define C1FLTOBJ12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x250U))
#define C1FLTOBJ12Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x250U))
#define C1FLTOBJ12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x252U))
#define C1FLTOBJ12Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x252U))
#define C1MASK12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x254U))
#define C1MASK12Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x254U))
#define C1MASK12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x256U))
#define C1MASK12Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x256U))
#define C1FLTOBJ13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x258U))
#define C1FLTOBJ13Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x258U))
#define C1FLTOBJ13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25AU))
#define C1FLTOBJ13Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25AU))
#define C1MASK13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25CU))
#define C1MASK13Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25CU))
#define C1MASK13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25EU))
#define C1MASK13Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x25EU))
#define C1FLTOBJ14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x260U))
#define C1FLTOBJ14Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x260U))
#define C1FLTOBJ14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x262U))
#define C1FLTOBJ14Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x262U))
#define C1MASK14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x264U))
#define C1MASK14Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x264U))
#define C1MASK14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x266U))
#define C1MASK14Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x266U))
#define C1FLTOBJ15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x268U))
#define C1FLTOBJ15Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x268U))
#define C1FLTOBJ15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26AU))
#define C1FLTOBJ15Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26AU))
#define C1MASK15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26CU))
#define C1MASK15Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26CU))
#define C1MASK15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26EU))
#define C1MASK15Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x26EU))
#define C1FLTOBJ16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x270U))
#define C1FLTOBJ16Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x270U))
#define C1FLTOBJ16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x272U))
#define C1FLTOBJ16Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x272U))
#define C1MASK16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x274U))
#define C1MASK16Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x274U))
#define C1MASK16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x276U))
#define C1MASK16Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x276U))
#define C1FLTOBJ17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x278U))
#define C1FLTOBJ17Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x278U))
#define C1FLTOBJ17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27AU))
#define C1FLTOBJ17Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27AU))
#define C1MASK17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27CU))
#define C1MASK17Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27CU))
#define C1MASK17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27EU))
#define C1MASK17Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x27EU))
#define C1FLTOBJ18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x280U))
#define C1FLTOBJ18Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x280U))
#define C1FLTOBJ18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x282U))
#define C1FLTOBJ18Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x282U))
#define C1MASK18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x284U))
#define C1MASK18Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x284U))
#define C1MASK18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x286U))
#define C1MASK18Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x286U))
#define C1FLTOBJ19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x288U))
#define C1FLTOBJ19Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x288U))
#define C1FLTOBJ19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28AU))
#define C1FLTOBJ19Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28AU))
#define C1MASK19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28CU))
#define C1MASK19Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28CU))
#define C1MASK19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28EU))
#define C1MASK19Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x28EU))
#define C1FLTOBJ20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x290U))
#define C1FLTOBJ20Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x290U))
#define C1FLTOBJ20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x292U))
#define C1FLTOBJ20Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x292U))
#define C1MASK20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x294U))
#define C1MASK20Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x294U))
#define C1MASK20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x296U))
#define C1MASK20Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x296U))
#define C1FLTOBJ21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x298U))
#define C1FLTOBJ21Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x298U))
#define C1FLTOBJ21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29AU))
#define C1FLTOBJ21Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29AU))
#define C1MASK21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29CU))
#define C1MASK21Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29CU))
#define C1MASK21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29EU))
#define C1MASK21Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x29EU))
#define C1FLTOBJ22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A0U))
#define C1FLTOBJ22Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A0U))
#define C1FLTOBJ22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A2U))
#define C1FLTOBJ22Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A2U))
#define C1MASK22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A4U))
#define C1MASK22Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A4U))
#define C1MASK22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A6U))
#define C1MASK22Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A6U))
#define C1FLTOBJ23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A8U))
#define C1FLTOBJ23Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2A8U))
#define C1FLTOBJ23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2AAU))
#define C1FLTOBJ23Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2AAU))
#define C1MASK23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2ACU))
#define C1MASK23Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2ACU))
#define C1MASK23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2AEU))
#define C1MASK23Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2AEU))
#define C1FLTOBJ24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B0U))
#define C1FLTOBJ24Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B0U))
#define C1FLTOBJ24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B2U))
#define C1FLTOBJ24Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B2U))
#define C1MASK24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B4U))
#define C1MASK24Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B4U))
#define C1MASK24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B6U))
#define C1MASK24Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B6U))
#define C1FLTOBJ25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B8U))
#define C1FLTOBJ25Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2B8U))
#define C1FLTOBJ25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BAU))
#define C1FLTOBJ25Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BAU))
#define C1MASK25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BCU))
#define C1MASK25Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BCU))
#define C1MASK25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BEU))
#define C1MASK25Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2BEU))
#define C1FLTOBJ26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C0U))
#define C1FLTOBJ26Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C0U))
#define C1FLTOBJ26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C2U))
#define C1FLTOBJ26Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C2U))
#define C1MASK26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C4U))
#define C1MASK26Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C4U))
#define C1MASK26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C6U))
#define C1MASK26Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C6U))
#define C1FLTOBJ27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C8U))
#define C1FLTOBJ27Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2C8U))
#define C1FLTOBJ27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CAU))
#define C1FLTOBJ27Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CAU))
#define C1MASK27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CCU))
#define C1MASK27Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CCU))
#define C1MASK27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CEU))
#define C1MASK27Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2CEU))
#define C1FLTOBJ28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D0U))
#define C1FLTOBJ28Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D0U))
#define C1FLTOBJ28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D2U))
#define C1FLTOBJ28Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D2U))
#define C1MASK28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D4U))
#define C1MASK28Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D4U))
#define C1MASK28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D6U))
#define C1MASK28Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D6U))
#define C1FLTOBJ29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D8U))
#define C1FLTOBJ29Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2D8U))
#define C1FLTOBJ29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DAU))
#define C1FLTOBJ29Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DAU))
#define C1MASK29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DCU))
#define C1MASK29Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DCU))
#define C1MASK29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DEU))
#define C1MASK29Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2DEU))
#define C1FLTOBJ30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E0U))
#define C1FLTOBJ30Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E0U))
#define C1FLTOBJ30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E2U))
#define C1FLTOBJ30Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E2U))
#define C1MASK30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E4U))
#define C1MASK30Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E4U))
#define C1MASK30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E6U))
#define C1MASK30Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E6U))
#define C1FLTOBJ31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E8U))
#define C1FLTOBJ31Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2E8U))
#define C1FLTOBJ31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2EAU))
#define C1FLTOBJ31Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2EAU))
#define C1MASK31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2ECU))
#define C1MASK31Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2ECU))
#define C1MASK31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2EEU))
#define C1MASK31Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C1_BASE + 0x2EEU))
#endif
#ifdef DSPIC33_CANFD_C2_BASE
#define C2CONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x000U))
#define C2CONLbits (*(volatile dspic33_canfd_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x000U))
#define C2CONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x002U))
#define C2CONHbits (*(volatile dspic33_canfd_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x002U))
#define C2NBTCFGL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x004U))
#define C2NBTCFGLbits (*(volatile dspic33_canfd_nbtcfg_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x004U))
#define C2NBTCFGH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x006U))
#define C2NBTCFGHbits (*(volatile dspic33_canfd_nbtcfg_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x006U))
#define C2DBTCFGL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x008U))
#define C2DBTCFGLbits (*(volatile dspic33_canfd_dbtcfg_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x008U))
#define C2DBTCFGH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00AU))
#define C2DBTCFGHbits (*(volatile dspic33_canfd_dbtcfg_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00AU))
#define C2TDCL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00CU))
#define C2TDCLbits (*(volatile dspic33_canfd_tdc_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00CU))
#define C2TDCH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00EU))
#define C2TDCHbits (*(volatile dspic33_canfd_tdc_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x00EU))
#define C2TBCL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x010U))
#define C2TBCLbits (*(const volatile dspic33_canfd_tbc_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x010U))
#define C2TBCH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x012U))
#define C2TBCHbits (*(const volatile dspic33_canfd_tbc_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x012U))
#define C2TSCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x014U))
#define C2TSCONLbits (*(volatile dspic33_canfd_tscon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x014U))
#define C2TSCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x016U))
#define C2TSCONHbits (*(volatile dspic33_canfd_tscon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x016U))
#define C2VECL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x018U))
#define C2VECLbits (*(const volatile dspic33_canfd_vec_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x018U))
#define C2VECH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01AU))
#define C2VECHbits (*(const volatile dspic33_canfd_vec_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01AU))
#define C2INTL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01CU))
#define C2INTLbits (*(const volatile dspic33_canfd_int_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01CU))
#define C2INTH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01EU))
#define C2INTHbits (*(volatile dspic33_canfd_int_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x01EU))
#define C2RXIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x020U))
#define C2RXIFLbits (*(const volatile dspic33_canfd_rxif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x020U))
#define C2RXIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x022U))
#define C2RXIFHbits (*(const volatile dspic33_canfd_rxif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x022U))
#define C2TXIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x024U))
#define C2TXIFLbits (*(const volatile dspic33_canfd_txif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x024U))
#define C2TXIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x026U))
#define C2TXIFHbits (*(const volatile dspic33_canfd_txif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x026U))
#define C2RXOVIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x028U))
#define C2RXOVIFLbits (*(const volatile dspic33_canfd_rxovif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x028U))
#define C2RXOVIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02AU))
#define C2RXOVIFHbits (*(const volatile dspic33_canfd_rxovif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02AU))
#define C2TXATIFL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02CU))
#define C2TXATIFLbits (*(const volatile dspic33_canfd_txatif_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02CU))
#define C2TXATIFH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02EU))
#define C2TXATIFHbits (*(const volatile dspic33_canfd_txatif_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x02EU))
#define C2TXREQL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x030U))
#define C2TXREQLbits (*(const volatile dspic33_canfd_txreq_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x030U))
#define C2TXREQH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x032U))
#define C2TXREQHbits (*(const volatile dspic33_canfd_txreq_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x032U))
#define C2TRECL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x034U))
#define C2TRECLbits (*(const volatile dspic33_canfd_trec_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x034U))
#define C2TRECH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x036U))
#define C2TRECHbits (*(const volatile dspic33_canfd_trec_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x036U))
#define C2BDIAG0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x038U))
#define C2BDIAG0Lbits (*(const volatile dspic33_canfd_bdiag0_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x038U))
#define C2BDIAG0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03AU))
#define C2BDIAG0Hbits (*(const volatile dspic33_canfd_bdiag0_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03AU))
#define C2BDIAG1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03CU))
#define C2BDIAG1Lbits (*(const volatile dspic33_canfd_bdiag1_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03CU))
#define C2BDIAG1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03EU))
#define C2BDIAG1Hbits (*(const volatile dspic33_canfd_bdiag1_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x03EU))
#define C2TEFCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x040U))
#define C2TEFCONLbits (*(volatile dspic33_canfd_tefcon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x040U))
#define C2TEFCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x042U))
#define C2TEFCONHbits (*(volatile dspic33_canfd_tefcon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x042U))
#define C2TEFSTA (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x044U))
#define C2TEFSTAbits (*(const volatile dspic33_canfd_tefsta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x044U))
#define C2TEFUAL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x048U))
#define C2TEFUALbits (*(const volatile dspic33_canfd_tefua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x048U))
#define C2TEFUAH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04AU))
#define C2TEFUAHbits (*(const volatile dspic33_canfd_tefua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04AU))
#define C2FIFOBAL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04CU))
#define C2FIFOBALbits (*(volatile dspic33_canfd_fifoba_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04CU))
#define C2FIFOBAH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04EU))
#define C2FIFOBAHbits (*(volatile dspic33_canfd_fifoba_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x04EU))
#define C2TXQCONL (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x050U))
#define C2TXQCONLbits (*(volatile dspic33_canfd_txqcon_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x050U))
#define C2TXQCONH (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x052U))
#define C2TXQCONHbits (*(volatile dspic33_canfd_txqcon_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x052U))
#define C2TXQSTA (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x054U))
#define C2TXQSTAbits (*(const volatile dspic33_canfd_txqsta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x054U))
#define C2TXQUAL (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x058U))
#define C2TXQUALbits (*(const volatile dspic33_canfd_txqua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x058U))
#define C2TXQUAH (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05AU))
#define C2TXQUAHbits (*(const volatile dspic33_canfd_txqua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05AU))
#define C2FIFOCON1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05CU))
#define C2FIFOCON1Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05CU))
#define C2FIFOCON1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05EU))
#define C2FIFOCON1Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x05EU))
#define C2FIFOSTA1 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x060U))
#define C2FIFOSTA1bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x060U))
#define C2FIFOUA1L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x064U))
#define C2FIFOUA1Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x064U))
#define C2FIFOUA1H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x066U))
#define C2FIFOUA1Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x066U))
#define C2FIFOCON2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x068U))
#define C2FIFOCON2Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x068U))
#define C2FIFOCON2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x06AU))
#define C2FIFOCON2Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x06AU))
#define C2FIFOSTA2 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x06CU))
#define C2FIFOSTA2bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x06CU))
#define C2FIFOUA2L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x070U))
#define C2FIFOUA2Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x070U))
#define C2FIFOUA2H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x072U))
#define C2FIFOUA2Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x072U))
#define C2FIFOCON3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x074U))
#define C2FIFOCON3Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x074U))
#define C2FIFOCON3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x076U))
#define C2FIFOCON3Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x076U))
#define C2FIFOSTA3 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x078U))
#define C2FIFOSTA3bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x078U))
#define C2FIFOUA3L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x07CU))
#define C2FIFOUA3Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x07CU))
#define C2FIFOUA3H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x07EU))
#define C2FIFOUA3Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x07EU))
#define C2FIFOCON4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x080U))
#define C2FIFOCON4Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x080U))
#define C2FIFOCON4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x082U))
#define C2FIFOCON4Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x082U))
#define C2FIFOSTA4 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x084U))
#define C2FIFOSTA4bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x084U))
#define C2FIFOUA4L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x088U))
#define C2FIFOUA4Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x088U))
#define C2FIFOUA4H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08AU))
#define C2FIFOUA4Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08AU))
#define C2FIFOCON5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08CU))
#define C2FIFOCON5Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08CU))
#define C2FIFOCON5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08EU))
#define C2FIFOCON5Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x08EU))
#define C2FIFOSTA5 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x090U))
#define C2FIFOSTA5bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x090U))
#define C2FIFOUA5L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x094U))
#define C2FIFOUA5Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x094U))
#define C2FIFOUA5H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x096U))
#define C2FIFOUA5Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x096U))
#define C2FIFOCON6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x098U))
#define C2FIFOCON6Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x098U))
#define C2FIFOCON6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x09AU))
#define C2FIFOCON6Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x09AU))
#define C2FIFOSTA6 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x09CU))
#define C2FIFOSTA6bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x09CU))
#define C2FIFOUA6L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A0U))
#define C2FIFOUA6Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A0U))
#define C2FIFOUA6H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A2U))
#define C2FIFOUA6Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A2U))
#define C2FIFOCON7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A4U))
#define C2FIFOCON7Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A4U))
#define C2FIFOCON7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A6U))
#define C2FIFOCON7Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A6U))
#define C2FIFOSTA7 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A8U))
#define C2FIFOSTA7bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0A8U))
#define C2FIFOUA7L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0ACU))
#define C2FIFOUA7Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0ACU))
#define C2FIFOUA7H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0AEU))
#define C2FIFOUA7Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0AEU))
#define C2FIFOCON8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B0U))
#define C2FIFOCON8Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B0U))
#define C2FIFOCON8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B2U))
#define C2FIFOCON8Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B2U))
#define C2FIFOSTA8 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B4U))
#define C2FIFOSTA8bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B4U))
#define C2FIFOUA8L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B8U))
#define C2FIFOUA8Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0B8U))
#define C2FIFOUA8H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BAU))
#define C2FIFOUA8Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BAU))
#define C2FIFOCON9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BCU))
#define C2FIFOCON9Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BCU))
#define C2FIFOCON9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BEU))
#define C2FIFOCON9Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0BEU))
#define C2FIFOSTA9 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C0U))
#define C2FIFOSTA9bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C0U))
#define C2FIFOUA9L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C4U))
#define C2FIFOUA9Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C4U))
#define C2FIFOUA9H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C6U))
#define C2FIFOUA9Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C6U))
#define C2FIFOCON10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C8U))
#define C2FIFOCON10Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0C8U))
#define C2FIFOCON10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0CAU))
#define C2FIFOCON10Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0CAU))
#define C2FIFOSTA10 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0CCU))
#define C2FIFOSTA10bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0CCU))
#define C2FIFOUA10L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D0U))
#define C2FIFOUA10Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D0U))
#define C2FIFOUA10H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D2U))
#define C2FIFOUA10Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D2U))
#define C2FIFOCON11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D4U))
#define C2FIFOCON11Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D4U))
#define C2FIFOCON11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D6U))
#define C2FIFOCON11Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D6U))
#define C2FIFOSTA11 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D8U))
#define C2FIFOSTA11bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0D8U))
#define C2FIFOUA11L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0DCU))
#define C2FIFOUA11Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0DCU))
#define C2FIFOUA11H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0DEU))
#define C2FIFOUA11Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0DEU))
#define C2FIFOCON12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E0U))
#define C2FIFOCON12Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E0U))
#define C2FIFOCON12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E2U))
#define C2FIFOCON12Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E2U))
#define C2FIFOSTA12 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E4U))
#define C2FIFOSTA12bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E4U))
#define C2FIFOUA12L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E8U))
#define C2FIFOUA12Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0E8U))
#define C2FIFOUA12H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0EAU))
#define C2FIFOUA12Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0EAU))
#define C2FIFOCON13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0ECU))
#define C2FIFOCON13Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0ECU))
#define C2FIFOCON13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0EEU))
#define C2FIFOCON13Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0EEU))
#define C2FIFOSTA13 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F0U))
#define C2FIFOSTA13bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F0U))
#define C2FIFOUA13L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F4U))
#define C2FIFOUA13Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F4U))
#define C2FIFOUA13H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F6U))
#define C2FIFOUA13Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F6U))
#define C2FIFOCON14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F8U))
#define C2FIFOCON14Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0F8U))
#define C2FIFOCON14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0FAU))
#define C2FIFOCON14Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0FAU))
#define C2FIFOSTA14 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0FCU))
#define C2FIFOSTA14bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x0FCU))
#define C2FIFOUA14L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x100U))
#define C2FIFOUA14Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x100U))
#define C2FIFOUA14H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x102U))
#define C2FIFOUA14Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x102U))
#define C2FIFOCON15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x104U))
#define C2FIFOCON15Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x104U))
#define C2FIFOCON15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x106U))
#define C2FIFOCON15Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x106U))
#define C2FIFOSTA15 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x108U))
#define C2FIFOSTA15bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x108U))
#define C2FIFOUA15L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x10CU))
#define C2FIFOUA15Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x10CU))
#define C2FIFOUA15H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x10EU))
#define C2FIFOUA15Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x10EU))
#define C2FIFOCON16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x110U))
#define C2FIFOCON16Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x110U))
#define C2FIFOCON16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x112U))
#define C2FIFOCON16Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x112U))
#define C2FIFOSTA16 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x114U))
#define C2FIFOSTA16bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x114U))
#define C2FIFOUA16L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x118U))
#define C2FIFOUA16Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x118U))
#define C2FIFOUA16H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11AU))
#define C2FIFOUA16Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11AU))
#define C2FIFOCON17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11CU))
#define C2FIFOCON17Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11CU))
#define C2FIFOCON17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11EU))
#define C2FIFOCON17Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x11EU))
#define C2FIFOSTA17 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x120U))
#define C2FIFOSTA17bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x120U))
#define C2FIFOUA17L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x124U))
#define C2FIFOUA17Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x124U))
#define C2FIFOUA17H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x126U))
#define C2FIFOUA17Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x126U))
#define C2FIFOCON18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x128U))
#define C2FIFOCON18Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x128U))
#define C2FIFOCON18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x12AU))
#define C2FIFOCON18Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x12AU))
#define C2FIFOSTA18 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x12CU))
#define C2FIFOSTA18bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x12CU))
#define C2FIFOUA18L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x130U))
#define C2FIFOUA18Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x130U))
#define C2FIFOUA18H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x132U))
#define C2FIFOUA18Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x132U))
#define C2FIFOCON19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x134U))
#define C2FIFOCON19Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x134U))
#define C2FIFOCON19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x136U))
#define C2FIFOCON19Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x136U))
#define C2FIFOSTA19 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x138U))
#define C2FIFOSTA19bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x138U))
#define C2FIFOUA19L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x13CU))
#define C2FIFOUA19Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x13CU))
#define C2FIFOUA19H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x13EU))
#define C2FIFOUA19Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x13EU))
#define C2FIFOCON20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x140U))
#define C2FIFOCON20Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x140U))
#define C2FIFOCON20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x142U))
#define C2FIFOCON20Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x142U))
#define C2FIFOSTA20 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x144U))
#define C2FIFOSTA20bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x144U))
#define C2FIFOUA20L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x148U))
#define C2FIFOUA20Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x148U))
#define C2FIFOUA20H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14AU))
#define C2FIFOUA20Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14AU))
#define C2FIFOCON21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14CU))
#define C2FIFOCON21Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14CU))
#define C2FIFOCON21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14EU))
#define C2FIFOCON21Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x14EU))
#define C2FIFOSTA21 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x150U))
#define C2FIFOSTA21bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x150U))
#define C2FIFOUA21L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x154U))
#define C2FIFOUA21Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x154U))
#define C2FIFOUA21H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x156U))
#define C2FIFOUA21Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x156U))
#define C2FIFOCON22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x158U))
#define C2FIFOCON22Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x158U))
#define C2FIFOCON22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x15AU))
#define C2FIFOCON22Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x15AU))
#define C2FIFOSTA22 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x15CU))
#define C2FIFOSTA22bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x15CU))
#define C2FIFOUA22L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x160U))
#define C2FIFOUA22Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x160U))
#define C2FIFOUA22H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x162U))
#define C2FIFOUA22Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x162U))
#define C2FIFOCON23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x164U))
#define C2FIFOCON23Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x164U))
#define C2FIFOCON23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x166U))
#define C2FIFOCON23Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x166U))
#define C2FIFOSTA23 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x168U))
#define C2FIFOSTA23bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x168U))
#define C2FIFOUA23L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x16CU))
#define C2FIFOUA23Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x16CU))
#define C2FIFOUA23H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x16EU))
#define C2FIFOUA23Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x16EU))
#define C2FIFOCON24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x170U))
#define C2FIFOCON24Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x170U))
#define C2FIFOCON24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x172U))
#define C2FIFOCON24Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x172U))
#define C2FIFOSTA24 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x174U))
#define C2FIFOSTA24bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x174U))
#define C2FIFOUA24L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x178U))
#define C2FIFOUA24Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x178U))
#define C2FIFOUA24H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17AU))
#define C2FIFOUA24Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17AU))
#define C2FIFOCON25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17CU))
#define C2FIFOCON25Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17CU))
#define C2FIFOCON25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17EU))
#define C2FIFOCON25Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x17EU))
#define C2FIFOSTA25 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x180U))
#define C2FIFOSTA25bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x180U))
#define C2FIFOUA25L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x184U))
#define C2FIFOUA25Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x184U))
#define C2FIFOUA25H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x186U))
#define C2FIFOUA25Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x186U))
#define C2FIFOCON26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x188U))
#define C2FIFOCON26Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x188U))
#define C2FIFOCON26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x18AU))
#define C2FIFOCON26Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x18AU))
#define C2FIFOSTA26 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x18CU))
#define C2FIFOSTA26bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x18CU))
#define C2FIFOUA26L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x190U))
#define C2FIFOUA26Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x190U))
#define C2FIFOUA26H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x192U))
#define C2FIFOUA26Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x192U))
#define C2FIFOCON27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x194U))
#define C2FIFOCON27Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x194U))
#define C2FIFOCON27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x196U))
#define C2FIFOCON27Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x196U))
#define C2FIFOSTA27 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x198U))
#define C2FIFOSTA27bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x198U))
#define C2FIFOUA27L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x19CU))
#define C2FIFOUA27Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x19CU))
#define C2FIFOUA27H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x19EU))
#define C2FIFOUA27Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x19EU))
#define C2FIFOCON28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A0U))
#define C2FIFOCON28Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A0U))
#define C2FIFOCON28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A2U))
#define C2FIFOCON28Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A2U))
#define C2FIFOSTA28 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A4U))
#define C2FIFOSTA28bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A4U))
#define C2FIFOUA28L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A8U))
#define C2FIFOUA28Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1A8U))
#define C2FIFOUA28H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1AAU))
#define C2FIFOUA28Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1AAU))
#define C2FIFOCON29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1ACU))
#define C2FIFOCON29Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1ACU))
#define C2FIFOCON29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1AEU))
#define C2FIFOCON29Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1AEU))
#define C2FIFOSTA29 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B0U))
#define C2FIFOSTA29bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B0U))
#define C2FIFOUA29L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B4U))
#define C2FIFOUA29Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B4U))
#define C2FIFOUA29H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B6U))
#define C2FIFOUA29Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B6U))
#define C2FIFOCON30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B8U))
#define C2FIFOCON30Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1B8U))
#define C2FIFOCON30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1BAU))
#define C2FIFOCON30Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1BAU))
#define C2FIFOSTA30 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1BCU))
#define C2FIFOSTA30bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1BCU))
#define C2FIFOUA30L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C0U))
#define C2FIFOUA30Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C0U))
#define C2FIFOUA30H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C2U))
#define C2FIFOUA30Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C2U))
#define C2FIFOCON31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C4U))
#define C2FIFOCON31Lbits (*(volatile dspic33_canfd_fifo_con_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C4U))
#define C2FIFOCON31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C6U))
#define C2FIFOCON31Hbits (*(volatile dspic33_canfd_fifo_con_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C6U))
#define C2FIFOSTA31 (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C8U))
#define C2FIFOSTA31bits (*(const volatile dspic33_canfd_fifo_sta_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1C8U))
#define C2FIFOUA31L (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1CCU))
#define C2FIFOUA31Lbits (*(const volatile dspic33_canfd_fifo_ua_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1CCU))
#define C2FIFOUA31H (*(const volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1CEU))
#define C2FIFOUA31Hbits (*(const volatile dspic33_canfd_fifo_ua_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1CEU))
#define C2FLTCON0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D0U))
#define C2FLTCON0Lbits (*(volatile dspic33_canfd_fltcon0l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D0U))
#define C2FLTCON0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D2U))
#define C2FLTCON0Hbits (*(volatile dspic33_canfd_fltcon0h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D2U))
#define C2FLTCON1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D4U))
#define C2FLTCON1Lbits (*(volatile dspic33_canfd_fltcon1l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D4U))
#define C2FLTCON1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D6U))
#define C2FLTCON1Hbits (*(volatile dspic33_canfd_fltcon1h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D6U))
#define C2FLTCON2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D8U))
#define C2FLTCON2Lbits (*(volatile dspic33_canfd_fltcon2l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1D8U))
#define C2FLTCON2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DAU))
#define C2FLTCON2Hbits (*(volatile dspic33_canfd_fltcon2h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DAU))
#define C2FLTCON3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DCU))
#define C2FLTCON3Lbits (*(volatile dspic33_canfd_fltcon3l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DCU))
#define C2FLTCON3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DEU))
#define C2FLTCON3Hbits (*(volatile dspic33_canfd_fltcon3h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1DEU))
#define C2FLTCON4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E0U))
#define C2FLTCON4Lbits (*(volatile dspic33_canfd_fltcon4l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E0U))
#define C2FLTCON4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E2U))
#define C2FLTCON4Hbits (*(volatile dspic33_canfd_fltcon4h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E2U))
#define C2FLTCON5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E4U))
#define C2FLTCON5Lbits (*(volatile dspic33_canfd_fltcon5l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E4U))
#define C2FLTCON5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E6U))
#define C2FLTCON5Hbits (*(volatile dspic33_canfd_fltcon5h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E6U))
#define C2FLTCON6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E8U))
#define C2FLTCON6Lbits (*(volatile dspic33_canfd_fltcon6l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1E8U))
#define C2FLTCON6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1EAU))
#define C2FLTCON6Hbits (*(volatile dspic33_canfd_fltcon6h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1EAU))
#define C2FLTCON7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1ECU))
#define C2FLTCON7Lbits (*(volatile dspic33_canfd_fltcon7l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1ECU))
#define C2FLTCON7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1EEU))
#define C2FLTCON7Hbits (*(volatile dspic33_canfd_fltcon7h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1EEU))
#define C2FLTOBJ0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F0U))
#define C2FLTOBJ0Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F0U))
#define C2FLTOBJ0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F2U))
#define C2FLTOBJ0Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F2U))
#define C2MASK0L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F4U))
#define C2MASK0Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F4U))
#define C2MASK0H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F6U))
#define C2MASK0Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F6U))
#define C2FLTOBJ1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F8U))
#define C2FLTOBJ1Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1F8U))
#define C2FLTOBJ1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FAU))
#define C2FLTOBJ1Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FAU))
#define C2MASK1L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FCU))
#define C2MASK1Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FCU))
#define C2MASK1H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FEU))
#define C2MASK1Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x1FEU))
#define C2FLTOBJ2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x200U))
#define C2FLTOBJ2Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x200U))
#define C2FLTOBJ2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x202U))
#define C2FLTOBJ2Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x202U))
#define C2MASK2L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x204U))
#define C2MASK2Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x204U))
#define C2MASK2H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x206U))
#define C2MASK2Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x206U))
#define C2FLTOBJ3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x208U))
#define C2FLTOBJ3Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x208U))
#define C2FLTOBJ3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20AU))
#define C2FLTOBJ3Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20AU))
#define C2MASK3L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20CU))
#define C2MASK3Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20CU))
#define C2MASK3H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20EU))
#define C2MASK3Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x20EU))
#define C2FLTOBJ4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x210U))
#define C2FLTOBJ4Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x210U))
#define C2FLTOBJ4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x212U))
#define C2FLTOBJ4Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x212U))
#define C2MASK4L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x214U))
#define C2MASK4Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x214U))
#define C2MASK4H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x216U))
#define C2MASK4Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x216U))
#define C2FLTOBJ5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x218U))
#define C2FLTOBJ5Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x218U))
#define C2FLTOBJ5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21AU))
#define C2FLTOBJ5Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21AU))
#define C2MASK5L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21CU))
#define C2MASK5Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21CU))
#define C2MASK5H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21EU))
#define C2MASK5Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x21EU))
#define C2FLTOBJ6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x220U))
#define C2FLTOBJ6Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x220U))
#define C2FLTOBJ6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x222U))
#define C2FLTOBJ6Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x222U))
#define C2MASK6L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x224U))
#define C2MASK6Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x224U))
#define C2MASK6H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x226U))
#define C2MASK6Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x226U))
#define C2FLTOBJ7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x228U))
#define C2FLTOBJ7Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x228U))
#define C2FLTOBJ7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22AU))
#define C2FLTOBJ7Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22AU))
#define C2MASK7L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22CU))
#define C2MASK7Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22CU))
#define C2MASK7H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22EU))
#define C2MASK7Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x22EU))
#define C2FLTOBJ8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x230U))
#define C2FLTOBJ8Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x230U))
#define C2FLTOBJ8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x232U))
#define C2FLTOBJ8Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x232U))
#define C2MASK8L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x234U))
#define C2MASK8Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x234U))
#define C2MASK8H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x236U))
#define C2MASK8Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x236U))
#define C2FLTOBJ9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x238U))
#define C2FLTOBJ9Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x238U))
#define C2FLTOBJ9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23AU))
#define C2FLTOBJ9Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23AU))
#define C2MASK9L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23CU))
#define C2MASK9Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23CU))
#define C2MASK9H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23EU))
#define C2MASK9Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x23EU))
#define C2FLTOBJ10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x240U))
#define C2FLTOBJ10Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x240U))
#define C2FLTOBJ10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x242U))
#define C2FLTOBJ10Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x242U))
#define C2MASK10L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x244U))
#define C2MASK10Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x244U))
#define C2MASK10H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x246U))
#define C2MASK10Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x246U))
#define C2FLTOBJ11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x248U))
#define C2FLTOBJ11Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x248U))
#define C2FLTOBJ11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24AU))
#define C2FLTOBJ11Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24AU))
#define C2MASK11L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24CU))
#define C2MASK11Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24CU))
#define C2MASK11H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24EU))
#define C2MASK11Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x24EU))
#define C2FLTOBJ12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x250U))
#define C2FLTOBJ12Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x250U))
#define C2FLTOBJ12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x252U))
#define C2FLTOBJ12Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x252U))
#define C2MASK12L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x254U))
#define C2MASK12Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x254U))
#define C2MASK12H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x256U))
#define C2MASK12Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x256U))
#define C2FLTOBJ13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x258U))
#define C2FLTOBJ13Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x258U))
#define C2FLTOBJ13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25AU))
#define C2FLTOBJ13Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25AU))
#define C2MASK13L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25CU))
#define C2MASK13Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25CU))
#define C2MASK13H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25EU))
#define C2MASK13Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x25EU))
#define C2FLTOBJ14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x260U))
#define C2FLTOBJ14Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x260U))
#define C2FLTOBJ14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x262U))
#define C2FLTOBJ14Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x262U))
#define C2MASK14L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x264U))
#define C2MASK14Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x264U))
#define C2MASK14H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x266U))
#define C2MASK14Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x266U))
#define C2FLTOBJ15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x268U))
#define C2FLTOBJ15Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x268U))
#define C2FLTOBJ15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26AU))
#define C2FLTOBJ15Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26AU))
#define C2MASK15L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26CU))
#define C2MASK15Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26CU))
#define C2MASK15H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26EU))
#define C2MASK15Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x26EU))
#define C2FLTOBJ16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x270U))
#define C2FLTOBJ16Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x270U))
#define C2FLTOBJ16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x272U))
#define C2FLTOBJ16Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x272U))
#define C2MASK16L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x274U))
#define C2MASK16Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x274U))
#define C2MASK16H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x276U))
#define C2MASK16Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x276U))
#define C2FLTOBJ17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x278U))
#define C2FLTOBJ17Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x278U))
#define C2FLTOBJ17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27AU))
#define C2FLTOBJ17Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27AU))
#define C2MASK17L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27CU))
#define C2MASK17Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27CU))
#define C2MASK17H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27EU))
#define C2MASK17Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x27EU))
#define C2FLTOBJ18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x280U))
#define C2FLTOBJ18Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x280U))
#define C2FLTOBJ18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x282U))
#define C2FLTOBJ18Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x282U))
#define C2MASK18L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x284U))
#define C2MASK18Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x284U))
#define C2MASK18H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x286U))
#define C2MASK18Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x286U))
#define C2FLTOBJ19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x288U))
#define C2FLTOBJ19Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x288U))
#define C2FLTOBJ19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28AU))
#define C2FLTOBJ19Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28AU))
#define C2MASK19L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28CU))
#define C2MASK19Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28CU))
#define C2MASK19H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28EU))
#define C2MASK19Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x28EU))
#define C2FLTOBJ20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x290U))
#define C2FLTOBJ20Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x290U))
#define C2FLTOBJ20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x292U))
#define C2FLTOBJ20Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x292U))
#define C2MASK20L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x294U))
#define C2MASK20Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x294U))
#define C2MASK20H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x296U))
#define C2MASK20Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x296U))
#define C2FLTOBJ21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x298U))
#define C2FLTOBJ21Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x298U))
#define C2FLTOBJ21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29AU))
#define C2FLTOBJ21Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29AU))
#define C2MASK21L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29CU))
#define C2MASK21Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29CU))
#define C2MASK21H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29EU))
#define C2MASK21Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x29EU))
#define C2FLTOBJ22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A0U))
#define C2FLTOBJ22Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A0U))
#define C2FLTOBJ22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A2U))
#define C2FLTOBJ22Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A2U))
#define C2MASK22L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A4U))
#define C2MASK22Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A4U))
#define C2MASK22H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A6U))
#define C2MASK22Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A6U))
#define C2FLTOBJ23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A8U))
#define C2FLTOBJ23Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2A8U))
#define C2FLTOBJ23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2AAU))
#define C2FLTOBJ23Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2AAU))
#define C2MASK23L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2ACU))
#define C2MASK23Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2ACU))
#define C2MASK23H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2AEU))
#define C2MASK23Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2AEU))
#define C2FLTOBJ24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B0U))
#define C2FLTOBJ24Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B0U))
#define C2FLTOBJ24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B2U))
#define C2FLTOBJ24Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B2U))
#define C2MASK24L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B4U))
#define C2MASK24Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B4U))
#define C2MASK24H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B6U))
#define C2MASK24Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B6U))
#define C2FLTOBJ25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B8U))
#define C2FLTOBJ25Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2B8U))
#define C2FLTOBJ25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BAU))
#define C2FLTOBJ25Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BAU))
#define C2MASK25L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BCU))
#define C2MASK25Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BCU))
#define C2MASK25H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BEU))
#define C2MASK25Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2BEU))
#define C2FLTOBJ26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C0U))
#define C2FLTOBJ26Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C0U))
#define C2FLTOBJ26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C2U))
#define C2FLTOBJ26Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C2U))
#define C2MASK26L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C4U))
#define C2MASK26Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C4U))
#define C2MASK26H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C6U))
#define C2MASK26Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C6U))
#define C2FLTOBJ27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C8U))
#define C2FLTOBJ27Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2C8U))
#define C2FLTOBJ27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CAU))
#define C2FLTOBJ27Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CAU))
#define C2MASK27L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CCU))
#define C2MASK27Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CCU))
#define C2MASK27H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CEU))
#define C2MASK27Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2CEU))
#define C2FLTOBJ28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D0U))
#define C2FLTOBJ28Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D0U))
#define C2FLTOBJ28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D2U))
#define C2FLTOBJ28Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D2U))
#define C2MASK28L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D4U))
#define C2MASK28Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D4U))
#define C2MASK28H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D6U))
#define C2MASK28Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D6U))
#define C2FLTOBJ29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D8U))
#define C2FLTOBJ29Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2D8U))
#define C2FLTOBJ29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DAU))
#define C2FLTOBJ29Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DAU))
#define C2MASK29L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DCU))
#define C2MASK29Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DCU))
#define C2MASK29H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DEU))
#define C2MASK29Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2DEU))
#define C2FLTOBJ30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E0U))
#define C2FLTOBJ30Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E0U))
#define C2FLTOBJ30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E2U))
#define C2FLTOBJ30Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E2U))
#define C2MASK30L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E4U))
#define C2MASK30Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E4U))
#define C2MASK30H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E6U))
#define C2MASK30Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E6U))
#define C2FLTOBJ31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E8U))
#define C2FLTOBJ31Lbits (*(volatile dspic33_canfd_flt_obj_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2E8U))
#define C2FLTOBJ31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2EAU))
#define C2FLTOBJ31Hbits (*(volatile dspic33_canfd_flt_obj_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2EAU))
#define C2MASK31L (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2ECU))
#define C2MASK31Lbits (*(volatile dspic33_canfd_mask_l_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2ECU))
#define C2MASK31H (*(volatile uint16_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2EEU))
#define C2MASK31Hbits (*(volatile dspic33_canfd_mask_h_bits_t *)((uintptr_t)DSPIC33_CANFD_C2_BASE + 0x2EEU))
#endif
#endif

#ifdef __cplusplus
}
#endif

#endif /* DSPIC33_CANFD_H */
