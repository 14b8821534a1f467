package lightning.shot.cluster.wire;

import lightning.base.text.UserFacingException;

/** Thrown for malformed messages; the message has the position, the expected and the actual data. */
public final class WireException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    WireException(String message) {
        super(message);
    }
}
