package lightning.editor.window.property;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.KeyEdits;
import lightning.document.ShotFrame;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.WindowLayout;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Track;

/**
 * Context menu of a property of a light, material or shape: copy, paste, reset and keyframes.
 *
 * <p>Copies are text in scene-file syntax ({@code intensity 2.5}), so that they can be pasted between items, windows and files.
 */
final class PropertyMenu {
    private static final PseudoClass KEYED = PseudoClass.getPseudoClass("keyed");
    private static final PseudoClass KEYED_AT_FRAME = PseudoClass.getPseudoClass("key-here");

    private final SceneEditor editor;
    private final WindowLayout layout;
    private final CommandMenuItems items;

    PropertyMenu(SceneEditor editor, CommandRegistry commands, WindowLayout layout) {
        this.editor = editor;
        this.layout = layout;
        items = CommandMenuItems.forMenu(commands);
    }

    /** Attaches the menu to a property's widget. */
    void attach(Node widget, SelectedProperty<?> property) {
        var menu = new ContextMenu();
        widget.setOnContextMenuRequested(e -> {
            menu.getItems().setAll(items(property));
            menu.show(widget, e.getScreenX(), e.getScreenY());
            e.consume();
        });
        editor.editorStateProperty().subscribe(state -> {
            Optional<Track> keys = state.shotFrame().flatMap(m -> property.track(m.shot()));
            widget.pseudoClassStateChanged(KEYED, keys.isPresent());
            widget.pseudoClassStateChanged(KEYED_AT_FRAME, keys.flatMap(t -> t.key(state.shotFrame().get().frame())).isPresent());
        });
    }

    private MenuItem[] items(SelectedProperty<?> property) {
        String title = SectionLayout.title(property.attribute().title());
        String clipboardValue = value(property, clipboardText());
        var copy = items.value(Command.COPY_PROPERTY, Messages.tr("Copy {0}", title), () -> copy(property));
        var paste = items.value(Command.PASTE_PROPERTY,
                Messages.tr("Paste {0}", title)
                        + (clipboardValue.isEmpty() ? Messages.tr(" (nothing copied)") : " " + Quote.of(clipboardValue)),
                () -> paste(property));
        var reset =
                items.value(Command.RESET_PROPERTY, Messages.tr("Reset {0}", title), () -> editor.editOrReport(property::reset));
        boolean hasNoValue = !property.isPresent();
        copy.setDisable(copy.isDisable() || hasNoValue);
        paste.setDisable(paste.isDisable() || hasNoValue || clipboardValue.isEmpty());
        reset.setDisable(reset.isDisable() || hasNoValue);
        if (!property.canHaveKeys(editor.scene())) {
            return new MenuItem[] {copy, paste, reset};
        }
        var key = items.value(Command.KEY_PROPERTY, keyTitle(title), () -> setKeyframe(property));
        var unkey = items.value(Command.UNKEY_PROPERTY, Messages.tr("Clear Keyframes of {0}", title), () -> removeKeyframes(property));
        unkey.setDisable(unkey.isDisable() || shotFrame().flatMap(f -> property.track(f.shot())).isEmpty());
        return new MenuItem[] {copy, paste, reset, new SeparatorMenuItem(), key, unkey};
    }

    private String keyTitle(String title) {
        return shotFrame().map(m -> Messages.tr("Set Keyframe of {0} at Frame {1}", title, m.frame()))
                .orElse(Messages.tr("Set Keyframe of {0} in a New Shot", title));
    }

    private void setKeyframe(SelectedProperty<?> property) {
        Scene shownScene = editor.scene();
        Optional<String> refusal = editor.editShotOrReport(scene -> {
            AnimatedScene sceneWithShot = KeyEdits.addShot(scene);
            int frame = shotFrame().map(ShotFrame::frame).orElseGet(() -> sceneWithShot.shot().orElseThrow().first());
            return KeyEdits.setKey(sceneWithShot, shownScene, property.element(), property.name(), frame);
        }, null);
        if (refusal.isEmpty()) {
            layout.timelineShownProperty().set(true);
        }
    }

    private Optional<ShotFrame> shotFrame() {
        return editor.document().shotFrame();
    }

    private void removeKeyframes(SelectedProperty<?> property) {
        Scene shownScene = editor.scene();
        editor.editShotOrReport(scene -> KeyEdits.removeKeys(scene, shownScene, property.element(), property.name()), null);
    }

    private static String clipboardText() {
        String text = Clipboard.getSystemClipboard().getString();
        return text == null ? "" : text.strip();
    }

    /** Returns the property's value in a copied text, or an empty string if the text describes another property. */
    private String value(SelectedProperty<?> property, String text) {
        return text.startsWith(property.name() + " ") && text.indexOf('\n') < 0 ? text.substring(property.name().length() + 1).strip()
                : "";
    }

    private void copy(SelectedProperty<?> property) {
        var content = new ClipboardContent();
        content.putString(property.name() + " " + property.text(editor.scene()));
        Clipboard.getSystemClipboard().setContent(content);
        editor.message().show(Messages.tr("Copied {0}", content.getString()));
    }

    private void paste(SelectedProperty<?> property) {
        String value = value(property, clipboardText());
        editor.editOrReport(scene -> property.set(scene, value));
    }
}
