package lightning.app;

/** How the editor looks, on top of its theme. */
final class Style {
    /** The address of the style sheet. */
    static final String SHEET = Style.class.getResource("lightning.css").toExternalForm();

    private Style() {}
}
