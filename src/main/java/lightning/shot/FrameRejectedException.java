package lightning.shot;

import lightning.base.text.UserFacingException;

/**
 * Thrown if a host cannot keep a frame that another host may, for lack of memory or of required files. The message is a sentence without
 * its full stop.
 */
public final class FrameRejectedException extends RuntimeException implements UserFacingException {
    private static final long serialVersionUID = 1;

    public FrameRejectedException(String message) {
        super(message);
    }
}
