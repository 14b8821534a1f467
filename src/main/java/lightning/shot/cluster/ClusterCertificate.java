package lightning.shot.cluster;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.Collections;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509ExtendedTrustManager;
import lightning.base.file.RegularFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import org.jspecify.annotations.Nullable;

/** Key and certificate shared by all members of a cluster, in a PKCS #12 file. Anyone with the file can join. */
public final class ClusterCertificate {
    /** The format requires a password; the file's permissions protect it. */
    static final char[] PASSWORD = "lightning".toCharArray();
    private static final int MAX_BYTES = 1 << 16;

    private ClusterCertificate() {}

    /**
     * Creates the TLS context for connections between members.
     *
     * @throws JoinException if the file cannot be read, or does not hold exactly one key with its certificate
     */
    public static SSLContext sslContext(Path file) throws JoinException {
        try {
            KeyStore store = KeyStore.getInstance("PKCS12");
            RegularFile.check(file, "a certificate");
            if (Files.size(file) > MAX_BYTES) {
                throw new CertificateException(Messages.tr("the file is larger than {0} bytes", MAX_BYTES));
            }
            try (InputStream in = Files.newInputStream(file)) {
                store.load(in, PASSWORD);
            }
            X509Certificate certificate = ownCertificate(store);
            certificate.checkValidity();
            KeyManagerFactory keys = KeyManagerFactory.getInstance("PKIX");
            keys.init(store, PASSWORD);
            SSLContext context = SSLContext.getInstance("TLSv1.3");
            context.init(keys.getKeyManagers(), new TrustManager[] {new CertificatePinning(certificate)}, new SecureRandom());
            return context;
        } catch (NoSuchFileException e) {
            throw new JoinException(
                    Messages.tr("{0}: file not found; create one with 'lightning node --make-certificate'", Quote.path(file)),
                    e);
        } catch (IOException | GeneralSecurityException e) {
            throw new JoinException(Messages.tr(
                    "{0}: expected a key and certificate from 'lightning node --make-certificate', found an unusable file: {1}",
                    Quote.path(file), e.getMessage() == null ? Messages.tr("not a certificate") : e.getMessage()), e);
        }
    }

    private static X509Certificate ownCertificate(KeyStore store) throws GeneralSecurityException {
        for (String alias : Collections.list(store.aliases())) {
            if (store.isKeyEntry(alias) && store.getCertificate(alias) instanceof X509Certificate own) {
                return own;
            }
        }
        throw new CertificateException(Messages.tr("the file contains no key"));
    }

    /** Trusts only peers that present the same certificate, and so have its key; ignores certificate authorities. */
    private static final class CertificatePinning extends X509ExtendedTrustManager {
        private final X509Certificate certificate;

        CertificatePinning(X509Certificate certificate) {
            this.certificate = certificate;
        }

        private void check(X509Certificate @Nullable [] chain) throws CertificateException {
            if (chain == null || chain.length == 0 || !MessageDigest.isEqual(chain[0].getEncoded(), certificate.getEncoded())) {
                throw new CertificateException("the certificate is not that of this cluster");
            }
            chain[0].checkValidity();
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
            check(chain);
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[] {certificate};
        }
    }
}
