package lightning.shot.cluster;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.KeyStore;
import java.security.SecureRandom;
import java.security.Signature;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.security.spec.ECGenParameterSpec;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.text.Quote;

/**
 * Generator of a key with a self-signed certificate (X.509 version 3 in DER, a P-256 key), like {@code keytool -genkeypair}, which some
 * Java runtimes lack.
 */
public final class SelfSignedCertificate {
    private static final int YEARS = 10;
    private static final int SERIAL_BITS = 127;
    private static final int INTEGER = 0x02;
    private static final int BITS = 0x03;
    private static final int OBJECT = 0x06;
    private static final int UTF8 = 0x0c;
    private static final int UTC_TIME = 0x17;
    private static final int GENERALIZED_TIME = 0x18;
    private static final int SEQUENCE = 0x30;
    private static final int SET = 0x31;
    private static final int VERSION = 0xa0;
    /** ecdsa-with-SHA256, 1.2.840.10045.4.3.2. */
    private static final byte[] ECDSA = {0x2a, (byte) 0x86, 0x48, (byte) 0xce, 0x3d, 0x04, 0x03, 0x02};
    /** commonName, 2.5.4.3. */
    private static final byte[] COMMON_NAME = {0x55, 0x04, 0x03};
    /** First year that a two-digit year cannot express: RFC 5280, section 4.1.2.5. */
    private static final int FIRST_GENERALIZED_YEAR = 2050;
    private static final DateTimeFormatter UTC = DateTimeFormatter.ofPattern("yyMMddHHmmss'Z'", Locale.ROOT);
    private static final DateTimeFormatter GENERALIZED = DateTimeFormatter.ofPattern("yyyyMMddHHmmss'Z'", Locale.ROOT);

    private SelfSignedCertificate() {}

    /**
     * Writes a new key and its certificate, readable by the owner only.
     *
     * @throws IOException if the file exists or cannot be written
     */
    public static void write(Path file) throws IOException {
        write(file, ZonedDateTime.now(ZoneOffset.UTC));
    }

    /** @param now UTC; the certificate is valid from a day before to ten years after */
    static void write(Path file, ZonedDateTime now) throws IOException {
        try {
            KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
            generator.initialize(new ECGenParameterSpec("secp256r1"));
            KeyPair keys = generator.generateKeyPair();
            Certificate certificate =
                    CertificateFactory.getInstance("X.509").generateCertificate(new ByteArrayInputStream(certificate(keys, now)));
            KeyStore store = KeyStore.getInstance("PKCS12");
            store.load(null, null);
            store.setKeyEntry("lightning", keys.getPrivate(), ClusterCertificate.PASSWORD, new Certificate[] {certificate});
            var bytes = new ByteArrayOutputStream();
            store.store(bytes, ClusterCertificate.PASSWORD);
            AtomicFile.of(file).forOwnerOnly().ifUnchanged(FileState.MISSING).write(bytes.toByteArray());
        } catch (ChangedFileException e) {
            throw new IOException(Quote.path(file) + ": already exists and is not overwritten; all machines of a cluster share one file",
                    e);
        } catch (GeneralSecurityException e) {
            throw new IOException("cannot create a certificate: " + e.getMessage(), e);
        }
    }

    private static byte[] certificate(KeyPair keys, ZonedDateTime now) throws GeneralSecurityException {
        byte[] algorithm = der(SEQUENCE, der(OBJECT, ECDSA));
        byte[] name = der(SEQUENCE, der(SET, der(SEQUENCE, der(OBJECT, COMMON_NAME),
                der(UTF8, "lightning".getBytes(StandardCharsets.UTF_8)))));
        // Valid immediately on machines whose clocks are slightly behind.
        byte[] validity = der(SEQUENCE, time(now.minusDays(1)), time(now.plusYears(YEARS)));
        byte[] serial = der(INTEGER, new BigInteger(SERIAL_BITS, new SecureRandom()).add(BigInteger.ONE).toByteArray());
        byte[] tbsCertificate = der(SEQUENCE, der(VERSION, der(INTEGER, new byte[] {2})), serial, algorithm, name, validity, name,
                keys.getPublic().getEncoded());
        Signature signature = Signature.getInstance("SHA256withECDSA");
        signature.initSign(keys.getPrivate());
        signature.update(tbsCertificate);
        return der(SEQUENCE, tbsCertificate, algorithm, der(BITS, new byte[1], signature.sign()));
    }

    private static byte[] time(ZonedDateTime at) {
        boolean generalized = at.getYear() >= FIRST_GENERALIZED_YEAR;
        return der(generalized ? GENERALIZED_TIME : UTC_TIME,
                (generalized ? GENERALIZED : UTC).format(at).getBytes(StandardCharsets.US_ASCII));
    }

    /** Encodes a DER value: tag, length, concatenated parts. */
    private static byte[] der(int tag, byte[]... parts) {
        var content = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            content.writeBytes(part);
        }
        var value = new ByteArrayOutputStream();
        value.write(tag);
        int length = content.size();
        if (length < 0x80) {
            value.write(length);
        } else {
            byte[] digits = BigInteger.valueOf(length).toByteArray();
            int from = digits[0] == 0 ? 1 : 0;
            value.write(0x80 | digits.length - from);
            value.write(digits, from, digits.length - from);
        }
        value.writeBytes(content.toByteArray());
        return value.toByteArray();
    }
}
