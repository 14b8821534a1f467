package lightning.shot;

import lightning.base.text.UserFacingException;

/**
 * Thrown if the frames of a shot fit neither into memory nor on disk. The message is a sentence without its full stop that says what would
 * fit.
 */
public final class ShotTooLargeException extends RuntimeException implements UserFacingException {
    private static final long serialVersionUID = 1;

    ShotTooLargeException(String message) {
        super(message);
    }
}
