//! The registers and fields that the model works with, by their names in the description.

use crate::registers::names::names;

names! {
    registers {
        crel = "CREL", cust = "CUST", dbtp = "DBTP", test = "TEST", rwd = "RWD", cccr = "CCCR", nbtp = "NBTP",
        tscc = "TSCC", tscv = "TSCV", tocc = "TOCC", tocv = "TOCV", ecr = "ECR", psr = "PSR", tdcr = "TDCR",
        ir = "IR", gfc = "GFC", sidfc = "SIDFC", xidfc = "XIDFC", xidam = "XIDAM", hpms = "HPMS",
        ndat1 = "NDAT1", ndat2 = "NDAT2", rxf0c = "RXF0C", rxf0s = "RXF0S", rxf0a = "RXF0A", rxbc = "RXBC",
        rxf1c = "RXF1C", rxf1s = "RXF1S", rxf1a = "RXF1A", rxesc = "RXESC", txbc = "TXBC", txfqs = "TXFQS",
        txesc = "TXESC", txbrp = "TXBRP", txbar = "TXBAR", txbcr = "TXBCR", txbto = "TXBTO", txbcf = "TXBCF",
        txbtie = "TXBTIE", txbcie = "TXBCIE", txefc = "TXEFC", txefs = "TXEFS", txefa = "TXEFA",
    }
    fields {
        init = cccr "INIT", asm = cccr "ASM", csr = cccr "CSR", csa = cccr "CSA",
        test_rx = test "RX", sval = test "SVAL", txbns = test "TXBNS", pval = test "PVAL", txbnp = test "TXBNP",
        wdv = rwd "WDV",
        tsc = tscv "TSC", toc = tocv "TOC",
        tec = ecr "TEC", rec = ecr "REC", rp = ecr "RP", cel = ecr "CEL",
        tdcv = psr "TDCV", pxe = psr "PXE", rfdf = psr "RFDF", rbrs = psr "RBRS", resi = psr "RESI",
        dlec = psr "DLEC", bo = psr "BO", ew = psr "EW", ep = psr "EP", act = psr "ACT", lec = psr "LEC",
        flst = hpms "FLST", fidx = hpms "FIDX", msi = hpms "MSI", bidx = hpms "BIDX",
        f0f = rxf0s "F0F", f0pi = rxf0s "F0PI", f0gi = rxf0s "F0GI", f0fl = rxf0s "F0FL",
        f1f = rxf1s "F1F", f1pi = rxf1s "F1PI", f1gi = rxf1s "F1GI", f1fl = rxf1s "F1FL", dms = rxf1s "DMS",
        tfqf = txfqs "TFQF", tfqpi = txfqs "TFQPI", tfgi = txfqs "TFGI", tffl = txfqs "TFFL",
        eff = txefs "EFF", efpi = txefs "EFPI", efgi = txefs "EFGI", effl = txefs "EFFL",
    }
}
