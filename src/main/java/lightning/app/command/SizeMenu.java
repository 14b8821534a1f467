package lightning.app.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.beans.property.ObjectProperty;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.TextInputDialog;
import javafx.scene.control.ToggleGroup;
import lightning.app.model.EditorModel;
import lightning.app.widget.CanvasSize;
import lightning.edit.Change;
import lightning.scene.Limits;
import lightning.scene.Picture;
import lightning.text.Quote;

/** The sizes of the two canvases (paper §3.6). */
public final class SizeMenu {
    private static final Pattern SIZE = Pattern.compile("\\s*(\\d{1,6})\\s*[x×*, ]\\s*(\\d{1,6})\\s*");

    private SizeMenu() {}

    /** Sizes of the traced picture; another size traces it anew. */
    public static List<MenuItem> ofPicture(EditorModel model) {
        List<MenuItem> items = new ArrayList<>();
        items.add(own(model));
        items.add(new SeparatorMenuItem());
        var group = new ToggleGroup();
        for (CanvasSize size : CanvasSize.FIXED) {
            var item = new RadioMenuItem(size.title());
            item.setId("size-" + size.width() + "x" + size.height());
            item.setToggleGroup(group);
            item.setOnAction(_ -> trace(model, size));
            model.sceneProperty()
                    .subscribe(s -> item.setSelected(s.picture().width() == size.width() && s.picture().height() == size.height()));
            items.add(item);
        }
        var other = new MenuItem("Other…");
        other.setId("size-other");
        other.setOnAction(_ -> ask(model.scene().picture().width() + " × " + model.scene().picture().height())
                .ifPresent(typed -> parse(typed).ifPresentOrElse(size -> trace(model, size),
                        () -> model.say("A size is two numbers as in 640 × 480, was " + Quote.of(typed.strip())))));
        items.add(new SeparatorMenuItem());
        items.add(other);
        return items;
    }

    /** The size that the scene's file says. */
    private static MenuItem own(EditorModel model) {
        var item = new MenuItem();
        item.setId("size-own");
        item.setOnAction(_ -> trace(model, ofFile(model)));
        model.situationProperty().subscribe(_ -> item.setText("The scene's own, " + ofFile(model).title()));
        return item;
    }

    private static CanvasSize ofFile(EditorModel model) {
        Picture picture = model.document().savedScene().picture();
        return CanvasSize.of(picture.width(), picture.height());
    }

    /** Sizes of the preview. */
    public static List<MenuItem> ofPreview(ObjectProperty<CanvasSize> chosen) {
        List<MenuItem> items = new ArrayList<>();
        var group = new ToggleGroup();
        List<CanvasSize> all = new ArrayList<>(List.of(CanvasSize.LIKE_PICTURE, CanvasSize.FREE));
        all.addAll(CanvasSize.FIXED);
        for (CanvasSize size : all) {
            var item = new RadioMenuItem(size.title());
            item.setToggleGroup(group);
            item.setOnAction(_ -> chosen.set(size));
            chosen.subscribe(now -> item.setSelected(now == size));
            items.add(item);
        }
        return items;
    }

    private static void trace(EditorModel model, CanvasSize size) {
        model.edit(scene -> Change.of(() -> scene.withPicture(scene.picture().withSize(size.width(), size.height()))))
                .ifPresentOrElse(model::say, model::go);
    }

    private static Optional<String> ask(String now) {
        var dialog = new TextInputDialog(now);
        dialog.setTitle("Size of the picture");
        dialog.setHeaderText("Width × height in pixels, each 1 to " + Limits.MAX_SIZE);
        dialog.setGraphic(null);
        dialog.setContentText("Size");
        return dialog.showAndWait();
    }

    /** {@code 640 x 480}; empty where it is no size. */
    public static Optional<CanvasSize> parse(String text) {
        Matcher matcher = SIZE.matcher(text);
        return matcher.matches() ? Optional.of(CanvasSize.of(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2))))
                : Optional.empty();
    }
}
