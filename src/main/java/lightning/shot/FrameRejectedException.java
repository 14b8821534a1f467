package lightning.shot;

import lightning.base.text.UserFacingException;

/** A keeper cannot hold a frame that another may: for want of room, or of what it needs for it. The message is a sentence without its full stop. */
public final class FrameRejectedException extends RuntimeException implements UserFacingException {
    private static final long serialVersionUID = 1;

    public FrameRejectedException(String message) {
        super(message);
    }
}
