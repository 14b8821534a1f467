package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.CheckBox;
import javafx.scene.control.TextField;
import javafx.scene.input.MouseButton;
import javafx.stage.Window;
import lightning.base.math.Rgb;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.WindowLayout;
import lightning.render.image.DisplayCurve;
import lightning.scene.light.Light;

/**
 * Makes the user's guide's pictures of the editor, one chapter in each process: a scene, steps like a user's, and pictures of the window or
 * of a panel.
 */
public final class GuidePictures {
    private static String chapter;
    private static Path folder;
    private final Editor editor;
    private final EditorModel model;
    private final Screen screen;

    private GuidePictures(Editor editor) throws Exception {
        this.editor = editor;
        model = editor.model();
        screen = new Screen();
    }

    /** Arguments: chapter, folder of the pictures, file to open. */
    public static void main(String[] arguments) {
        chapter = arguments[0];
        folder = Path.of(arguments[1]);
        LightningApp.open(Session.class, arguments.length > 2 ? List.of(arguments[2]) : List.of());
        System.exit(0);
    }

    /** The program with the file of the chapter. */
    public static final class Session extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> {
                int result = 0;
                try {
                    new GuidePictures(editor).run();
                } catch (Throwable e) {
                    e.printStackTrace();
                    result = 1;
                }
                Runtime.getRuntime().halt(result);
            });
        }
    }

    private void run() throws Exception {
        if (!chapter.equals("import")) {
            idle();
        }
        switch (chapter) {
            case "overview" -> overview();
            case "lights" -> lights();
            case "measure" -> measure();
            case "placing" -> placing();
            case "display" -> display();
            case "material" -> material();
            case "shot" -> shot();
            case "german" -> whole("german");
            case "import" -> importModel();
            default -> throw new IllegalArgumentException(chapter);
        }
    }

    private void overview() throws Exception {
        command(Command.ARRANGE_LIGHT);
        select(0);
        whole("editor");
    }

    private void lights() throws Exception {
        select(0);
        panel("#lights", "lights");
        panel("#properties", "properties");
        panel("#preview", "preview");
        open(Command.MIXER, "#mixer", 1000, 460);
        // Thumbnails appear while the editor is idle.
        Thread.sleep(40 * Screen.DRAW_MS);
        panel("#mixer", "mixer");
        open(Command.CONTRIBUTIONS, "#contributions", 760, 480);
        Thread.sleep(10 * Screen.DRAW_MS);
        panel("#contributions", "contributions");
        open(Command.LOOKS, "#looks", 860, 640);
        look("as it was");
        edit(0, light -> light.withIntensity(light.intensity() * 0.2));
        tint(new Rgb(0.35, 0.5, 1));
        look("night");
        tint(new Rgb(1, 0.6, 0.3));
        look("warm");
        compare();
        panel("#looks", "looks");
        open(Command.HISTORY_PANEL, "#history", 380, 400);
        panel("#history", "history");
        open(Command.SCOPES, "#scopes", 540, 560);
        panel("#scopes", "scopes");
        Platform.runLater(() -> model.commands().run(Command.PALETTE));
        TextField query = (TextField) Screen.node("#palette-query");
        run(() -> query.setText("light"));
        panel("#palette", "palette");
    }

    /** Records an edit's times, then compares settings and effects. */
    private void measure() throws Exception {
        select(0);
        edit(0, light -> light.withIntensity(light.intensity() * 1.2));
        edit(1, light -> light.withPosition(light.position().plus(light.direction().times(0.1))));
        edit(0, light -> light.withIntensity(light.intensity() * 1.1));
        Thread.sleep(30_000);
        open(Command.UPDATES_PANEL, "#updates", 1020, 420);
        panel("#updates", "updates");
        command(Command.ACCURACY_PANEL);
        measured("", "accuracy");
        panel("#accuracy", "accuracy");
        command(Command.EFFECTS_PANEL);
        measured("-effects", "effects");
        panel("#effects", "effects-cost");
    }

    private void placing() throws Exception {
        select(0);
        run(() -> model.layout().canvasLayoutProperty().set(WindowLayout.CanvasLayout.PICTURE_ALONE));
        command(Command.PLACE_HIGHLIGHT);
        Bounds picture = Screen.bounds(Screen.node("#traced-picture"));
        screen.move(picture.getMinX() + 0.47 * picture.getWidth(), picture.getMinY() + 0.42 * picture.getHeight());
        run(() -> screen.robot.mousePress(MouseButton.PRIMARY));
        screen.move(picture.getMinX() + 0.5 * picture.getWidth(), picture.getMinY() + 0.36 * picture.getHeight());
        panel("#traced", "placing");
        run(() -> screen.robot.mouseRelease(MouseButton.PRIMARY));
        idle();
        screen.move(picture.getMinX() + 0.55 * picture.getWidth(), picture.getMinY() + 0.5 * picture.getHeight());
        panel("#traced", "traced");
        command(Command.MARK_CLIPPING);
        run(() -> model.picture().viewProperty().set(model.picture().viewProperty().get().withExposure(1.5)));
        panel("#traced", "clipping");
    }

    private void display() throws Exception {
        run(() -> model.layout().canvasLayoutProperty().set(WindowLayout.CanvasLayout.PICTURE_ALONE));
        run(() -> model.picture().viewProperty().set(model.picture().viewProperty().get().withCurve(DisplayCurve.FALSE)));
        panel("#traced", "false-color");
    }

    private void material() throws Exception {
        String shape = model.editor().scene().placedShapes().getFirst().shape().name();
        run(() -> {
            model.editor().selection().selectNode(shape);
            model.editor().materialShownProperty().set(true);
        });
        whole("material");
        run(() -> model.editor().materialShownProperty().set(false));
        command(Command.EFFECTS_PANEL);
        CheckBox shadows = (CheckBox) Screen.node("#effect-shadows");
        run(shadows::fire);
        panel("#effects", "effects");
    }

    private void shot() throws Exception {
        command(Command.ARRANGE_SHOT);
        Thread.sleep(40_000);
        idle();
        panel("#timeline", "timeline");
        command(Command.TIMELINE);
    }

    private void importModel() throws Exception {
        Thread.sleep(20_000);
        Node dialog = onWindow(() -> Window.getWindows().getLast().getScene().getRoot());
        capture(dialog, "units");
    }

    /** Opens a panel in a window of its own. */
    private void open(Command panel, String selector, double width, double height) throws Exception {
        run(() -> model.layout().panelsProperty().set(model.layout().panelsProperty().get().open(panel).move(panel, PanelPlace.WINDOW)));
        idle();
        Window window = Screen.node(selector).getScene().getWindow();
        run(() -> {
            window.setX(20);
            window.setY(40);
            window.setWidth(width);
            window.setHeight(height);
        });
    }

    /** Compares the second with the third look. */
    private void compare() throws Exception {
        Node pane = Screen.node("#looks");
        run(() -> {
            List<Node> a =
                    pane.lookupAll(".toggle-button").stream().filter(n -> n instanceof ButtonBase b && b.getText().equals("A")).toList();
            List<Node> b =
                    pane.lookupAll(".toggle-button").stream().filter(n -> n instanceof ButtonBase c && c.getText().equals("B")).toList();
            ((ButtonBase) a.get(1)).fire();
            ((ButtonBase) b.get(2)).fire();
        });
        Thread.sleep(5 * Screen.DRAW_MS);
    }

    private void look(String name) throws Exception {
        TextField field = (TextField) Screen.node("#look-new-name");
        run(() -> {
            field.setText(name);
            ((Button) field.getScene().lookup("#look-keep")).fire();
        });
        Thread.sleep(3 * Screen.DRAW_MS);
    }

    /** Presses a panel's button, and waits for the end of its measurement. */
    private void measured(String suffix, String pane) throws Exception {
        Button measure = (Button) Screen.node("#" + pane + " #measure" + suffix);
        run(measure::fire);
        Node cancel = Screen.node("#" + pane + " #cancel-measure" + suffix);
        await(cancel::isDisabled);
    }

    private void select(int light) throws Exception {
        run(() -> model.editor().selection().selectLight(model.editor().scene().lights().get(light).name()));
    }

    /** Gives all lights a color. */
    private void tint(Rgb color) throws Exception {
        for (int i = 0; i < model.editor().scene().lights().size(); i++) {
            edit(i, light -> light.withColor(color));
        }
    }

    private void edit(int light, UnaryOperator<Light> change) throws Exception {
        String name = model.editor().scene().lights().get(light).name();
        run(() -> model.editor().edit(scene -> LightEdits.edit(scene, name, change)));
        idle();
    }

    private void command(Command command) throws Exception {
        run(() -> model.commands().run(command));
        idle();
    }

    private static void run(Runnable task) throws Exception {
        onWindow(() -> {
            task.run();
            return null;
        });
        Thread.sleep(Screen.DRAW_MS);
    }

    private void idle() throws Exception {
        Callable<Boolean> idle = () -> editor.isIdle() && !model.editor().editorStateProperty().get().hasPendingEdits();
        do {
            Thread.sleep(3 * Screen.DRAW_MS);
        } while (!onWindow(idle));
    }

    private void whole(String name) throws Exception {
        capture(Screen.node("#traced").getScene().getRoot(), name);
    }

    private void panel(String selector, String name) throws Exception {
        capture(Screen.node(selector), name);
    }

    private void capture(Node node, String name) throws Exception {
        Bounds at = Screen.bounds(node);
        Bounds window = Screen.bounds(node.getScene().getRoot());
        double width = Math.min(at.getMaxX(), window.getMaxX()) - at.getMinX();
        double height = Math.min(at.getMaxY(), window.getMaxY()) - at.getMinY();
        screen.capture(new Rectangle2D(at.getMinX(), at.getMinY(), width, height), folder.resolve(name + ".png"));
        System.out.println(name);
    }
}
