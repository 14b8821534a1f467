package lightning.app.property;

import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import lightning.app.command.CommandItems;
import lightning.app.model.EditorModel;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.LightEdits;
import lightning.jen.PropertyEdit;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Scene;
import lightning.text.Quote;

/**
 * The menu of one property of the selected light: copy, paste, reset. What is copied is text, in the words of the scene file
 * ({@code intensity 2.5}), so that it goes from light to light, from window to window, and into a file.
 */
final class PropertyMenu {
    private final EditorModel model;
    private final CommandItems items;
    private final LightAttribute<?> attribute;

    private PropertyMenu(EditorModel model, LightAttribute<?> attribute) {
        this.model = model;
        this.attribute = attribute;
        items = CommandItems.of(model);
    }

    /** Opens at a right click on what shows the property. */
    static void on(Node widget, EditorModel model, LightAttribute<?> attribute) {
        var menu = new PropertyMenu(model, attribute);
        var shown = new ContextMenu();
        widget.setOnContextMenuRequested(e -> {
            shown.getItems().setAll(menu.items());
            shown.show(widget, e.getScreenX(), e.getScreenY());
            e.consume();
        });
    }

    private MenuItem[] items() {
        String title = Sections.title(attribute.title());
        String there = value(copied());
        var copy = items.value(Command.COPY_PROPERTY, "Copy " + title, this::copy);
        var paste = items.value(Command.PASTE_PROPERTY, "Paste " + title + (there.isEmpty() ? " (none is copied)" : " " + Quote.of(there)),
                this::paste);
        paste.setDisable(paste.isDisable() || there.isEmpty());
        var reset = items.value(Command.RESET_PROPERTY, "Reset " + title, () -> model.edit(this::reset).ifPresent(model::say));
        return new MenuItem[] {copy, paste, reset};
    }

    private static String copied() {
        String text = Clipboard.getSystemClipboard().getString();
        return text == null ? "" : text.strip();
    }

    /** What a copied text says of the property; empty where it speaks of another. */
    private String value(String text) {
        return text.startsWith(attribute.name() + " ") && text.indexOf('\n') < 0 ? text.substring(attribute.name().length() + 1).strip()
                : "";
    }

    private void copy() {
        var content = new ClipboardContent();
        content.putString(attribute.name() + " " + PropertyEdit.text(model.selectedLight(), attribute));
        Clipboard.getSystemClipboard().setContent(content);
        model.say("Copied " + content.getString());
    }

    private void paste() {
        String value = value(copied());
        String light = model.selectedLight().name();
        model.edit(scene -> LightEdits.property(scene, light, attribute, value)).ifPresent(model::say);
    }

    private Change reset(Scene scene) {
        return LightEdits.with(scene, model.selectedLight().name(), light -> initial(light, attribute));
    }

    private static <V> Light initial(Light light, LightAttribute<V> attribute) {
        return attribute.with(light, attribute.initial());
    }
}
