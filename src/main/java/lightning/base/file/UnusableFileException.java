package lightning.base.file;

import java.io.IOException;
import lightning.base.text.UserFacingException;

/** File that cannot be used; the message is a sentence with the cause. */
public final class UnusableFileException extends IOException implements UserFacingException {
    private static final long serialVersionUID = 1;

    /** @param message one sentence, with the name of the file */
    public UnusableFileException(String message) {
        super(message);
    }

    @Override
    public String getMessage() {
        return String.valueOf(super.getMessage());
    }
}
