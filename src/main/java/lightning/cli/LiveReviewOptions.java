package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import lightning.cli.output.BadInputException;
import lightning.review.live.LiveAddress;
import lightning.shot.cluster.ClusterCertificate;
import lightning.shot.cluster.JoinException;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options of live reviews. */
final class LiveReviewOptions {
    @Option(names = "--live", description = "Show a live page at a local address until you stop the command.")
    private boolean live;
    @Option(names = "--allow-edits", description = "With --live: pages may change lights and the exposure.")
    private boolean allowsEdits;
    @Option(names = "--address", paramLabel = "HOST[:PORT]",
            description = "With --live: address for other computers, which needs a certificate (default: this computer only, any port).")
    private @Nullable String address;
    @Option(names = "--certificate", paramLabel = "FILE",
            description = "With --address: key and certificate of 'lightning node --make-certificate'.")
    private @Nullable Path certificate;

    boolean isOn() {
        return live;
    }

    boolean allowsEdits() {
        return allowsEdits;
    }

    /** Refuses options that need --live, and a file that nothing would be written to. */
    void check(boolean isApplied, boolean hasOutput) throws BadInputException {
        if (!live && (allowsEdits || address != null || certificate != null)) {
            throw new BadInputException("review: --allow-edits, --address and --certificate need --live");
        }
        if (live && isApplied) {
            throw new BadInputException("review: expected one of --live and --apply");
        }
        if (live && hasOutput && !allowsEdits) {
            throw new BadInputException("review: with --live, -o needs --allow-edits: nothing would change the scene");
        }
    }

    /**
     * Returns where to listen.
     *
     * @throws IOException if it is no address
     * @throws JoinException if the certificate cannot be used
     */
    LiveAddress where() throws IOException, JoinException {
        return address == null && certificate == null ? LiveAddress.LOCAL
                : LiveAddress.parse(address == null ? LiveAddress.LOCAL.host() : address,
                        certificate == null ? Optional.empty() : Optional.of(ClusterCertificate.sslContext(certificate)));
    }
}
