package lightning.editor.window.traced;

import java.util.Locale;
import java.util.function.UnaryOperator;
import javafx.scene.control.Menu;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/** The choice of anti-aliasing: which pixels are made of several samples, and of how many. An edit that Go renders. */
public final class SamplingMenu {
    private static final int[] GRIDS = {2, 3, 4, 8};

    private SamplingMenu() {}

    /** @param items make the menu's items; the ids end in {@code off}, {@code edges}, {@code every}, and {@code 2} to {@code 8} */
    public static Menu of(SceneEditor editor, CommandItems items) {
        Menu menu = items.menu(Command.ANTIALIAS);
        for (Antialias antialias : Antialias.values()) {
            menu.getItems().add(items.choice(Command.ANTIALIAS, "antialias-" + antialias.name().toLowerCase(Locale.ROOT), title(antialias),
                    editor.sceneProperty().map(s -> sampling(s).antialias() == antialias),
                    () -> choose(editor, now -> new Sampling(antialias, now.grid()))));
        }
        menu.getItems().add(new SeparatorMenuItem());
        for (int grid : GRIDS) {
            menu.getItems()
                    .add(items.choice(Command.SAMPLES, "antialias-" + grid, Texts.of("{0} × {1} Samples in Such a Pixel", grid, grid),
                            editor.sceneProperty().map(s -> sampling(s).grid() == grid),
                            () -> choose(editor, now -> new Sampling(now.antialias(), grid))));
        }
        return menu;
    }

    private static void choose(SceneEditor editor, UnaryOperator<Sampling> choice) {
        editor.editOrReport(scene -> Change.of(() -> scene.withPicture(scene.picture().withSampling(choice.apply(sampling(scene))))));
    }

    private static Sampling sampling(Scene scene) {
        return scene.picture().sampling();
    }

    private static String title(Antialias antialias) {
        return switch (antialias) {
            case OFF -> Texts.of("Off");
            case EDGES -> Texts.of("Edges");
            case EVERY -> Texts.of("Every Pixel");
        };
    }

    /** What stands behind the size of the picture: {@code , edges 4 × 4}; empty where pixels have one sample. */
    public static String text(Scene scene) {
        Sampling now = sampling(scene);
        return now.isFine() ? ", " + title(now.antialias()).toLowerCase(Locale.ROOT) + " " + now.grid() + " × " + now.grid() : "";
    }
}
