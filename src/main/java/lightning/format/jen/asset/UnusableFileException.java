package lightning.format.jen.asset;

import lightning.base.text.UserFacingException;

/** Referenced file that cannot be used; the message is a sentence with the cause. */
public final class UnusableFileException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    /** @param message one sentence, with the name of the file */
    public UnusableFileException(String message) {
        super(message);
    }
}
