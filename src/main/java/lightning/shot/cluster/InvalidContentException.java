package lightning.shot.cluster;

import java.io.IOException;

/** Content that came is not what it should be; no fault of this machine's disk. The message is a sentence without its full stop. */
final class InvalidContentException extends IOException {
    private static final long serialVersionUID = 1;

    InvalidContentException(String message) {
        super(message);
    }
}
