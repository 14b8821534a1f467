package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.security.cert.X509Certificate;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks the certificate's bytes with an independent DER reader. */
final class SelfSignedCertificateTest {
    private static final int UTC_TIME = 0x17;
    private static final int GENERALIZED_TIME = 0x18;
    private static final int SEQUENCE = 0x30;

    @TempDir
    private Path folder;

    /** Tag and content of a value. */
    private record Der(int tag, ByteBuffer content) {
        static Der next(ByteBuffer from) {
            int tag = from.get() & 0xff;
            int first = from.get() & 0xff;
            int length = first;
            if (first > 0x7f) {
                byte[] digits = new byte[first - 0x80];
                from.get(digits);
                length = new BigInteger(1, digits).intValueExact();
            }
            ByteBuffer content = from.slice(from.position(), length);
            from.position(from.position() + length);
            return new Der(tag, content);
        }

        String text() {
            return StandardCharsets.US_ASCII.decode(content.duplicate()).toString();
        }
    }

    private X509Certificate certificate(ZonedDateTime now) throws Exception {
        Path file = folder.resolve(now.getYear() + ".p12");
        SelfSignedCertificate.write(file, now);
        KeyStore store = KeyStore.getInstance("PKCS12");
        try (InputStream in = Files.newInputStream(file)) {
            store.load(in, ClusterCertificate.PASSWORD);
        }
        return (X509Certificate) store.getCertificate("lightning");
    }

    /** The fields of TBSCertificate up to validity: version, serial number, signature, issuer. */
    private static Der validity(X509Certificate certificate) throws Exception {
        Der signed = Der.next(ByteBuffer.wrap(certificate.getTBSCertificate()));
        for (int field = 0; field < 4; field++) {
            Der.next(signed.content());
        }
        Der validity = Der.next(signed.content());
        assertThat(validity.tag()).isEqualTo(SEQUENCE);
        return validity;
    }

    private void check(int year, int firstTag, String first, int lastTag, String last) throws Exception {
        X509Certificate certificate = certificate(ZonedDateTime.of(year, 3, 2, 1, 2, 3, 0, ZoneOffset.UTC));
        ByteBuffer times = validity(certificate).content();
        Der from = Der.next(times);
        Der until = Der.next(times);
        assertThat(from.tag()).isEqualTo(firstTag);
        assertThat(from.text()).isEqualTo(first);
        assertThat(until.tag()).isEqualTo(lastTag);
        assertThat(until.text()).isEqualTo(last);
        assertThat(times.hasRemaining()).isFalse();
        assertThat(certificate.getNotAfter().toInstant())
                .isEqualTo(ZonedDateTime.of(year + 10, 3, 2, 1, 2, 3, 0, ZoneOffset.UTC).toInstant());
        certificate.verify(certificate.getPublicKey());
    }

    @Test
    void yearsThrough2049_useTwoDigits_laterYearsFour() throws Exception {
        check(2026, UTC_TIME, "260301010203Z", UTC_TIME, "360302010203Z");
        check(2039, UTC_TIME, "390301010203Z", UTC_TIME, "490302010203Z");
        check(2040, UTC_TIME, "400301010203Z", GENERALIZED_TIME, "20500302010203Z");
        check(2050, GENERALIZED_TIME, "20500301010203Z", GENERALIZED_TIME, "20600302010203Z");
    }
}
