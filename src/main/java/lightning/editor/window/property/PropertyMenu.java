package lightning.editor.window.property;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.Moment;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Arrangement;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Track;

/**
 * The menu of one property of a light, a material or a shape: copy, paste, reset. What is copied is text, in the words of the scene file
 * ({@code intensity 2.5}), so that it goes from one to another, from window to window, and into a file.
 */
final class PropertyMenu {
    private static final PseudoClass KEYED = PseudoClass.getPseudoClass("keyed");
    private static final PseudoClass KEY_HERE = PseudoClass.getPseudoClass("key-here");

    private final SceneEditor editor;
    private final Arrangement arrangement;
    private final CommandItems items;

    PropertyMenu(SceneEditor editor, Commands commands, Arrangement arrangement) {
        this.editor = editor;
        this.arrangement = arrangement;
        items = CommandItems.of(commands);
    }

    /** Opens at a right click on what shows the property. */
    void on(Node widget, PropertyOwner property) {
        var shown = new ContextMenu();
        widget.setOnContextMenuRequested(e -> {
            shown.getItems().setAll(items(property));
            shown.show(widget, e.getScreenX(), e.getScreenY());
            e.consume();
        });
        editor.situationProperty().subscribe(now -> {
            Optional<Track> keys = now.moment().filter(_ -> property.text().isPresent())
                    .flatMap(m -> m.shot().track(property.keyTarget(), property.name()));
            widget.pseudoClassStateChanged(KEYED, keys.isPresent());
            widget.pseudoClassStateChanged(KEY_HERE, keys.flatMap(t -> t.key(now.moment().get().frame())).isPresent());
        });
    }

    private MenuItem[] items(PropertyOwner property) {
        String title = Sections.title(property.title());
        String there = value(property, copied());
        var copy = items.value(Command.COPY_PROPERTY, Texts.of("Copy {0}", title), () -> copy(property));
        var paste = items.value(Command.PASTE_PROPERTY,
                Texts.of("Paste {0}", title) + (there.isEmpty() ? Texts.of(" (none is copied)") : " " + Quote.of(there)),
                () -> paste(property));
        var reset =
                items.value(Command.RESET_PROPERTY, Texts.of("Reset {0}", title), () -> editor.editOrReport(property::reset));
        boolean none = property.text().isEmpty();
        copy.setDisable(copy.isDisable() || none);
        paste.setDisable(paste.isDisable() || none || there.isEmpty());
        reset.setDisable(reset.isDisable() || none);
        if (!property.keyed(editor.scene())) {
            return new MenuItem[] {copy, paste, reset};
        }
        var key = items.value(Command.KEY_PROPERTY, keyTitle(title), () -> key(property));
        var unkey = items.value(Command.UNKEY_PROPERTY, Texts.of("Remove Keys of {0}", title), () -> unkey(property));
        unkey.setDisable(unkey.isDisable() || moment().flatMap(m -> m.shot().track(property.keyTarget(), property.name())).isEmpty());
        return new MenuItem[] {copy, paste, reset, new SeparatorMenuItem(), key, unkey};
    }

    private String keyTitle(String title) {
        return moment().map(m -> Texts.of("Key {0} at Frame {1}", title, m.frame())).orElse(Texts.of("Key {0} in a New Shot", title));
    }

    private void key(PropertyOwner property) {
        Scene shown = editor.scene();
        Optional<String> refusal = editor.editAllOrReport(scene -> {
            AnimatedScene begun = KeyEdits.begin(scene);
            int frame = moment().map(Moment::frame).orElseGet(() -> begun.shot().orElseThrow().first());
            return KeyEdits.key(begun, shown, property.keyTarget(), property.name(), frame);
        }, null);
        if (refusal.isEmpty()) {
            arrangement.timelineShownProperty().set(true);
        }
    }

    private Optional<Moment> moment() {
        return editor.document().moment();
    }

    private void unkey(PropertyOwner property) {
        Scene shown = editor.scene();
        editor.editAllOrReport(scene -> KeyEdits.unkey(scene, shown, property.keyTarget(), property.name()), null);
    }

    private static String copied() {
        String text = Clipboard.getSystemClipboard().getString();
        return text == null ? "" : text.strip();
    }

    /** What a copied text says of the property; empty where it speaks of another. */
    private String value(PropertyOwner property, String text) {
        return text.startsWith(property.name() + " ") && text.indexOf('\n') < 0 ? text.substring(property.name().length() + 1).strip()
                : "";
    }

    private void copy(PropertyOwner property) {
        var content = new ClipboardContent();
        content.putString(property.name() + " " + property.text().orElseThrow());
        Clipboard.getSystemClipboard().setContent(content);
        editor.message().show(Texts.of("Copied {0}", content.getString()));
    }

    private void paste(PropertyOwner property) {
        String value = value(property, copied());
        editor.editOrReport(scene -> property.set(scene, value));
    }
}
