package lightning.editor.window.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.beans.property.ObjectProperty;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.TextInputDialog;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.CanvasSize;
import lightning.scene.Limits;
import lightning.scene.Picture;

/** The sizes of the two canvases (paper §3.6). */
public final class SizeMenu {
    private static final Pattern SIZE = Pattern.compile("\\s*(\\d{1,6})\\s*[x×*, ]\\s*(\\d{1,6})\\s*");

    private SizeMenu() {}

    /**
     * Sizes of the traced picture; another size traces it anew.
     *
     * @param items make the menu's items
     */
    public static List<MenuItem> ofPicture(SceneEditor editor, CommandItems items) {
        List<MenuItem> all = new ArrayList<>();
        all.add(own(editor, items));
        all.add(new SeparatorMenuItem());
        for (CanvasSize size : CanvasSize.FIXED) {
            all.add(items.choice(Command.PICTURE_SIZE, "size-" + size.width() + "x" + size.height(), size.title(),
                    editor.sceneProperty().map(s -> s.picture().width() == size.width() && s.picture().height() == size.height()),
                    () -> trace(editor, size)));
        }
        all.add(new SeparatorMenuItem());
        MenuItem other = items.value(Command.PICTURE_SIZE, Texts.of("Other…"), () -> other(editor));
        other.setId("size-other");
        all.add(other);
        return all;
    }

    private static void other(SceneEditor editor) {
        ask(editor.scene().picture().width() + " × " + editor.scene().picture().height())
                .ifPresent(typed -> parse(typed).ifPresentOrElse(size -> trace(editor, size),
                        () -> editor.message().show(Texts.of("A size is two numbers as in 640 × 480, was {0}", Quote.of(typed.strip())))));
    }

    /** The size that the scene's file says. */
    private static MenuItem own(SceneEditor editor, CommandItems items) {
        MenuItem item = items.value(Command.PICTURE_SIZE, "", () -> trace(editor, ofFile(editor)));
        item.setId("size-own");
        editor.situationProperty().subscribe(_ -> item.setText(Texts.of("The scene's own, {0}", ofFile(editor).title())));
        return item;
    }

    private static CanvasSize ofFile(SceneEditor editor) {
        Picture picture = editor.document().savedScene().picture();
        return CanvasSize.of(picture.width(), picture.height());
    }

    /** Sizes of the preview. */
    public static List<MenuItem> ofPreview(Commands commands, ObjectProperty<CanvasSize> chosen) {
        CommandItems items = CommandItems.of(commands, "preview-");
        return Stream.concat(Stream.of(CanvasSize.LIKE_PICTURE, CanvasSize.FREE), CanvasSize.FIXED.stream())
                .map(size -> items.choice(Command.PREVIEW_SIZE, size.title(), Texts.of(size.title()), chosen.map(size::equals),
                        () -> chosen.set(size)))
                .toList();
    }

    private static void trace(SceneEditor editor, CanvasSize size) {
        if (editor.editOrReport(scene -> Change.of(() -> scene.withPicture(scene.picture().withSize(size.width(), size.height()))))
                .isEmpty()) {
            editor.go();
        }
    }

    private static Optional<String> ask(String now) {
        var dialog = new TextInputDialog(now);
        dialog.setTitle(Texts.of("Size of the picture"));
        dialog.setHeaderText(Texts.of("Width × height in pixels, each 1 to {0}", Limits.MAX_SIZE));
        dialog.setGraphic(null);
        dialog.setContentText(Texts.of("Size"));
        return dialog.showAndWait();
    }

    /** {@code 640 x 480}; empty where it is no size. */
    public static Optional<CanvasSize> parse(String text) {
        Matcher matcher = SIZE.matcher(text);
        return matcher.matches() ? Optional.of(CanvasSize.of(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2))))
                : Optional.empty();
    }
}
