package lightning.editor.window.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.beans.property.ObjectProperty;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.TextInputDialog;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WorkingSize;
import lightning.editor.window.widget.CanvasSize;
import lightning.scene.PictureSettings;
import lightning.scene.value.SceneLimits;

/** Menus for the sizes of the two canvases (paper §3.6). */
public final class SizeMenu {
    private static final Pattern SIZE = Pattern.compile("\\s*(\\d{1,6})\\s*[x×*, ]\\s*(\\d{1,6})\\s*");

    private SizeMenu() {}

    /**
     * Returns the sizes in which the picture is traced while the scene is edited, and those of the scene, in which it is exported. Choosing one
     * traces the picture again.
     *
     * @param items factory of the menu's items
     */
    public static List<MenuItem> pictureSizeItems(SceneEditor editor, CommandMenuItems items, WindowLayout layout) {
        List<MenuItem> all = new ArrayList<>();
        for (WorkingSize size : WorkingSize.values()) {
            all.add(items.choice(Command.WORKING_SIZE, "working-" + size.name().toLowerCase(Locale.ROOT), size.toString(),
                    layout.workingSizeProperty().map(chosen -> chosen == size), () -> layout.workingSizeProperty().set(size)));
        }
        all.add(new SeparatorMenuItem());
        all.add(paneSizeItem(editor, items, layout));
        all.add(sceneSizeItem(editor, items));
        all.add(new SeparatorMenuItem());
        for (CanvasSize size : CanvasSize.FIXED) {
            all.add(items.choice(Command.PICTURE_SIZE, "size-" + size.width() + "x" + size.height(), size.title(),
                    editor.sceneProperty().map(s -> s.picture().width() == size.width() && s.picture().height() == size.height()),
                    () -> setSizeAndTrace(editor, size)));
        }
        all.add(new SeparatorMenuItem());
        MenuItem other = items.value(Command.PICTURE_SIZE, Messages.tr("Custom…"), () -> promptSize(editor));
        other.setId("size-other");
        all.add(other);
        return all;
    }

    private static void promptSize(SceneEditor editor) {
        showSizeDialog(editor.scene().picture().width() + " × " + editor.scene().picture().height())
                .ifPresent(typed -> parse(typed).ifPresentOrElse(size -> setSizeAndTrace(editor, size),
                        () -> editor.message()
                                .show(Messages.tr("Resolution: expected width × height such as 640 × 480, found {0}",
                                        Quote.of(typed.strip())))));
    }

    /** Creates the item for the largest size that fits the pane. */
    private static MenuItem paneSizeItem(SceneEditor editor, CommandMenuItems items, WindowLayout layout) {
        MenuItem item = items.value(Command.PICTURE_SIZE, Messages.tr("Fit to Pane"), () -> {
            PictureSettings fitted = layout.pictureArea().fit(editor.scene().picture());
            setSizeAndTrace(editor, CanvasSize.of(fitted.width(), fitted.height()));
        });
        item.setId("size-pane");
        return item;
    }

    /** Creates the item for the size stored in the scene file. */
    private static MenuItem sceneSizeItem(SceneEditor editor, CommandMenuItems items) {
        MenuItem item = items.value(Command.PICTURE_SIZE, "", () -> setSizeAndTrace(editor, fileSize(editor)));
        item.setId("size-own");
        editor.editorStateProperty().subscribe(_ -> item.setText(Messages.tr("Scene Default ({0})", fileSize(editor).title())));
        return item;
    }

    private static CanvasSize fileSize(SceneEditor editor) {
        PictureSettings picture = editor.document().savedScene().picture();
        return CanvasSize.of(picture.width(), picture.height());
    }

    /** Returns the sizes of the preview. */
    public static List<MenuItem> previewSizeItems(CommandRegistry commands, ObjectProperty<CanvasSize> chosen) {
        CommandMenuItems items = CommandMenuItems.forMenu(commands, "preview-");
        return Stream.concat(Stream.of(CanvasSize.PICTURE_ASPECT, CanvasSize.FREE), CanvasSize.FIXED.stream())
                .map(size -> items.choice(Command.PREVIEW_SIZE, size.title(), Messages.tr(size.title()), chosen.map(size::equals),
                        () -> chosen.set(size)))
                .toList();
    }

    private static void setSizeAndTrace(SceneEditor editor, CanvasSize size) {
        if (editor.editOrReport(scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withSize(size.width(), size.height()))))
                .isEmpty()) {
            editor.go();
        }
    }

    private static Optional<String> showSizeDialog(String currentSize) {
        var dialog = new TextInputDialog(currentSize);
        dialog.setTitle(Messages.tr("Resolution"));
        dialog.setHeaderText(Messages.tr("Width × height in pixels, each 1 to {0}", SceneLimits.MAX_SIZE));
        dialog.setGraphic(null);
        dialog.setContentText(Messages.tr("Size"));
        return dialog.showAndWait();
    }

    /** Parses a size such as {@code 640 x 480}; empty if invalid. */
    public static Optional<CanvasSize> parse(String text) {
        Matcher matcher = SIZE.matcher(text);
        return matcher.matches() ? Optional.of(CanvasSize.of(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2))))
                : Optional.empty();
    }
}
