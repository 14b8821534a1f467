package lightning.editor.window.traced;

import java.util.Locale;
import java.util.function.UnaryOperator;
import javafx.scene.control.Menu;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/** Menu of anti-aliasing modes and sample counts. The choice is an edit of the scene. */
public final class SamplingMenu {
    private static final int[] GRIDS = {2, 3, 4, 8};

    private SamplingMenu() {}

    /**
     * Creates the menu.
     *
     * @param items creates the menu's items; their ids end in {@code off}, {@code edges}, {@code every}, and {@code 2} to {@code 8}
     */
    public static Menu of(SceneEditor editor, CommandMenuItems items) {
        Menu menu = items.menu(Command.ANTIALIAS);
        for (AntialiasMode antialias : AntialiasMode.values()) {
            menu.getItems().add(items.choice(Command.ANTIALIAS, "antialias-" + antialias.name().toLowerCase(Locale.ROOT), title(antialias),
                    editor.sceneProperty().map(s -> sampling(s).antialias() == antialias),
                    () -> editSampling(editor, now -> new SamplingSettings(antialias, now.grid()))));
        }
        menu.getItems().add(new SeparatorMenuItem());
        for (int grid : GRIDS) {
            menu.getItems()
                    .add(items.choice(Command.SAMPLES, "antialias-" + grid, Messages.tr("{0} × {1} Samples per Pixel", grid, grid),
                            editor.sceneProperty().map(s -> sampling(s).grid() == grid),
                            () -> editSampling(editor, now -> new SamplingSettings(now.antialias(), grid))));
        }
        return menu;
    }

    private static void editSampling(SceneEditor editor, UnaryOperator<SamplingSettings> edit) {
        editor.editOrReport(scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withSampling(edit.apply(sampling(scene))))));
    }

    private static SamplingSettings sampling(Scene scene) {
        return scene.picture().sampling();
    }

    private static String title(AntialiasMode antialias) {
        return switch (antialias) {
            case OFF -> Messages.tr("Off");
            case EDGES -> Messages.tr("Edges");
            case EVERY -> Messages.tr("Every Pixel");
        };
    }

    /** Returns the suffix for the picture's size, such as {@code , edges 4 × 4}; empty without anti-aliasing. */
    public static String text(Scene scene) {
        SamplingSettings sampling = sampling(scene);
        return !sampling.isSupersampled() ? "" : switch (sampling.antialias()) {
            case OFF -> "";
            case EDGES -> Messages.tr(", edges {0} × {0}", sampling.grid());
            case EVERY -> Messages.tr(", every pixel {0} × {0}", sampling.grid());
        };
    }
}
