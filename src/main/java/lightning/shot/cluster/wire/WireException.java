package lightning.shot.cluster.wire;

import lightning.base.text.UserFacingException;

/** Bytes that are no message; the sentence tells where, what was expected and what was found. */
public final class WireException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    WireException(String message) {
        super(message);
    }
}
