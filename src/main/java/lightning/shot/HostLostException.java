package lightning.shot;

import lightning.base.text.UserFacingException;

/** What held frames is there no more, as when its process ended: others trace them again. The message is a sentence. */
public final class HostLostException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    public HostLostException(String message, Throwable cause) {
        super(message, cause);
    }
}
