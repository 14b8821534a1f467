package lightning.cli.output;

import lightning.base.text.UserFacingException;
import org.jspecify.annotations.Nullable;

/** Bad input or an impossible request; the message is a sentence for the user. */
public final class BadInputException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    public BadInputException(@Nullable String message) {
        super(message);
    }
}
