package lightning.app.traced;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import lightning.app.model.EditorModel;
import lightning.edit.Change;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/** The choice of anti-aliasing: which pixels are made of several samples, and of how many. An edit that Go renders. */
public final class SamplingMenu {
    private static final int[] GRIDS = {2, 3, 4, 8};

    private SamplingMenu() {}

    /** @param prefix of the items' ids, which end in {@code off}, {@code edges}, {@code every}, and {@code 2} to {@code 8} */
    public static Menu of(EditorModel model, String prefix) {
        List<MenuItem> items = new ArrayList<>();
        var which = new ToggleGroup();
        for (Antialias antialias : Antialias.values()) {
            items.add(item(model, prefix + "-" + antialias.name().toLowerCase(Locale.ROOT), title(antialias), which,
                    now -> new Sampling(antialias, now.grid()), now -> now.antialias() == antialias));
        }
        items.add(new SeparatorMenuItem());
        var grids = new ToggleGroup();
        for (int grid : GRIDS) {
            MenuItem item = item(model, prefix + "-" + grid, grid + " × " + grid + " Samples in Such a Pixel", grids,
                    now -> new Sampling(now.antialias(), grid), now -> now.grid() == grid);
            model.sceneProperty().subscribe(s -> item.setDisable(!sampling(s).isFine()));
            items.add(item);
        }
        var menu = new Menu("Anti-Aliasing");
        menu.setId(prefix);
        menu.getItems().setAll(items);
        return menu;
    }

    private interface Choice {
        Sampling from(Sampling now);
    }

    private static MenuItem item(EditorModel model, String id, String title, ToggleGroup group, Choice choice,
            Predicate<Sampling> chosen) {
        var item = new RadioMenuItem(title);
        item.setId(id);
        item.setToggleGroup(group);
        item.setOnAction(
                _ -> model.edit(scene -> Change.of(() -> scene.withPicture(scene.picture().withSampling(choice.from(sampling(scene))))))
                        .ifPresent(model::say));
        model.sceneProperty().subscribe(s -> item.setSelected(chosen.test(sampling(s))));
        return item;
    }

    private static Sampling sampling(Scene scene) {
        return scene.picture().sampling();
    }

    private static String title(Antialias antialias) {
        return switch (antialias) {
            case OFF -> "Off";
            case EDGES -> "Edges";
            case EVERY -> "Every Pixel";
        };
    }

    /** What stands behind the size of the picture: {@code , edges 4 × 4}; empty where pixels have one sample. */
    public static String text(Scene scene) {
        Sampling now = sampling(scene);
        return now.isFine() ? ", " + title(now.antialias()).toLowerCase(Locale.ROOT) + " " + now.grid() + " × " + now.grid() : "";
    }
}
