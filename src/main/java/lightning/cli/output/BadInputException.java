package lightning.cli.output;

import lightning.base.text.UserFacingException;

/** Bad input or an impossible request; the message is a sentence for the user. */
public final class BadInputException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    public BadInputException(String message) {
        super(message);
    }
}
