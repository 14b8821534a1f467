package lightning.format.jen;

import lightning.base.text.UserFacingException;

/** Says in a sentence why a file that a scene names cannot be used. */
public final class UnusableFileException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    UnusableFileException(String message) {
        super(message);
    }
}
