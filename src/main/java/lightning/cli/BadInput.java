package lightning.cli;

import lightning.base.text.Told;

/** A command cannot do what it was asked; the message is a sentence for the user. */
final class BadInput extends Exception implements Told {
    private static final long serialVersionUID = 1;

    BadInput(String message) {
        super(message);
    }
}
