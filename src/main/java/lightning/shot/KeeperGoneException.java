package lightning.shot;

import lightning.base.text.Told;

/** What held frames is there no more, as when its process ended: others trace them again. The message is a sentence. */
public final class KeeperGoneException extends Exception implements Told {
    private static final long serialVersionUID = 1;

    public KeeperGoneException(String message, Throwable cause) {
        super(message, cause);
    }
}
