package lightning.cli;

/** A command cannot do what it was asked; the message is a sentence for the user. */
final class BadInput extends Exception {
    private static final long serialVersionUID = 1;

    BadInput(String message) {
        super(message);
    }
}
