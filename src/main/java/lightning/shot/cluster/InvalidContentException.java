package lightning.shot.cluster;

import java.io.IOException;

/** Thrown if received content is invalid, rather than this machine's disk failing. The message is a sentence without its full stop. */
final class InvalidContentException extends IOException {
    private static final long serialVersionUID = 1;

    InvalidContentException(String message) {
        super(message);
    }
}
