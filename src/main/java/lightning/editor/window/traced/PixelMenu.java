package lightning.editor.window.traced;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Messages;
import lightning.document.CameraEdits;
import lightning.document.LightAtPoint;
import lightning.document.LinkEdits;
import lightning.document.loop.Frame;
import lightning.document.manipulation.LightPlacement.Goal;
import lightning.document.manipulation.ScenePicker;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.ShapeLinks;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Context menu of a pixel of the traced picture: the lights that light it, placements of the selected light at that point, new lights, light
 * linking, and the commands of the object.
 */
final class PixelMenu {
    /** Maximum number of lights in the menu itself; others are in a submenu. */
    private static final int MAX_LIT = 4;
    /** Maximum number of lights in the submenu. */
    private static final int MAX_OTHERS = 40;
    private static final List<LightType> TYPES =
            List.of(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL, LightType.RECT, LightType.DISC, LightType.TUBE);

    /**
     * Pixel that the menu is about.
     *
     * @param frame displayed picture
     * @param canvas size of the whole picture as displayed
     */
    record Target(Frame frame, PixelReport report, Viewport canvas) {}

    private final SceneEditor editor;
    private final CommandMenuItems items;
    private final ShapeMenu shapeMenu;
    private final LightPlacer placer;
    private final ContextMenu menu = new ContextMenu();

    PixelMenu(EditorModel model, LightPlacer placer) {
        editor = model.editor();
        CommandRegistry commands = model.commands();
        items = CommandMenuItems.forMenu(commands, "pixel-");
        shapeMenu = new ShapeMenu(editor, model.materials(), commands);
        this.placer = placer;
    }

    /** Shows the menu at a screen position, or a message if the pixel shows no object. */
    void show(Node owner, Target target, double x, double y) {
        hide();
        PixelReport report = target.report();
        ScenePicker picker = ScenePicker.of(target.frame().scene(), target.frame().geometry());
        Optional<ScenePicker.SurfaceHit> hit = report.point() == null ? Optional.empty() : picker.pickPixel(report.x(), report.y());
        if (hit.isEmpty()) {
            editor.message().show(Messages.tr("No object here"));
            return;
        }
        List<MenuItem> all = new ArrayList<>(lights(report));
        all.add(new SeparatorMenuItem());
        all.add(aim(hit.get(), picker, target.canvas()));
        all.add(placements(hit.get(), picker, target.canvas()));
        all.add(newLights(picker, hit.get(), target.canvas()));
        all.add(items.value(Command.FOCUS, Messages.tr("Focus Here"),
                () -> editor.editOrReport(scene -> CameraEdits.focus(scene, hit.get().point()))));
        all.add(new SeparatorMenuItem());
        Light selected = editor.selection().light();
        if (selected != null && report.face().isEmpty()) {
            all.add(link(selected, LightAttribute.ILLUMINATES, report.shape(), Messages.tr("{0} Illuminates {1}", selected.name(),
                    report.shape())));
            all.add(link(selected, LightAttribute.SHADOWED_BY, report.shape(), Messages.tr("{1} Casts Shadows from {0}", selected.name(),
                    report.shape())));
            all.add(new SeparatorMenuItem());
        }
        all.addAll(shapeMenu.items(report.shape()));
        menu.getItems().setAll(all);
        menu.show(owner, x, y);
    }

    void hide() {
        menu.hide();
    }

    /** Returns an item for each light, the strongest first; those that do not light the pixel are in a submenu. */
    private List<MenuItem> lights(PixelReport report) {
        List<PixelReport.LightShare> sorted = report.contributions().stream()
                .sorted(Comparator.comparingDouble(PixelReport.LightShare::brightness).reversed()).toList();
        int litCount = (int) sorted.stream().limit(MAX_LIT).filter(c -> c.brightness() > 0).count();
        List<MenuItem> list = new ArrayList<>(sorted.subList(0, litCount).stream().map(this::light).toList());
        report.otherLines().forEach(line -> list.add(CommandMenuItems.placeholder(Command.SELECT_LIGHT, line)));
        if (list.isEmpty()) {
            list.add(CommandMenuItems.placeholder(Command.SELECT_LIGHT, Messages.tr("No light reaches this point")));
        }
        List<PixelReport.LightShare> others = sorted.subList(litCount, sorted.size());
        if (!others.isEmpty()) {
            Menu submenu = new Menu(Messages.tr("Other Lights"));
            others.stream().limit(MAX_OTHERS).map(this::light).forEach(submenu.getItems()::add);
            if (others.size() > MAX_OTHERS) {
                submenu.getItems().add(CommandMenuItems.placeholder(Command.SELECT_LIGHT,
                        Messages.tr("{0} more in the light list", others.size() - MAX_OTHERS)));
            }
            list.add(submenu);
        }
        return list;
    }

    private MenuItem light(PixelReport.LightShare contribution) {
        String name = contribution.light().name();
        MenuItem item = items.value(Command.SELECT_LIGHT, name + "  " + contribution.text(), () -> editor.selection().selectLight(name));
        item.setGraphic(new FontIcon(LightTypes.icon(contribution.light().type())));
        return item;
    }

    private MenuItem aim(ScenePicker.SurfaceHit hit, ScenePicker picker, Viewport canvas) {
        String name = editor.selection().lightName();
        return place(Command.AIM, name.isEmpty() ? Messages.tr("Aim Light Here") : Messages.tr("Aim {0} Here", name), new Goal.Pool(), hit,
                picker, canvas);
    }

    private Menu placements(ScenePicker.SurfaceHit hit, ScenePicker picker, Viewport canvas) {
        Menu submenu = items.menu(Command.PLACE_HIGHLIGHT,
                place(Command.PLACE_HIGHLIGHT, Messages.tr("Highlight Here"), new Goal.Highlight(), hit, picker, canvas),
                place(Command.PLACE_DIFFUSE, Messages.tr("Facing the Surface Here"), new Goal.Diffuse(), hit, picker, canvas),
                place(Command.PLACE_RIM, Messages.tr("Rim Light Here"), new Goal.Rim(), hit, picker, canvas),
                place(Command.PLACE_FLAG, Messages.tr("Flag Here"), new Goal.Flag(), hit, picker, canvas),
                items.value(Command.PLACE_SHADOW, Messages.tr("Shadow Here…"), () -> placer.pickCaster(hit)));
        String name = editor.selection().lightName();
        submenu.setMnemonicParsing(false);
        submenu.setText(name.isEmpty() ? Messages.tr("Place Light") : Messages.tr("Place {0}", name));
        submenu.setDisable(name.isEmpty());
        return submenu;
    }

    private MenuItem place(Command command, String title, Goal goal, ScenePicker.SurfaceHit hit, ScenePicker picker, Viewport canvas) {
        return items.value(command, title, () -> placer.placeAt(hit, goal, picker, canvas));
    }

    private Menu newLights(ScenePicker picker, ScenePicker.SurfaceHit hit, Viewport canvas) {
        Menu submenu = items.menu(Command.ADD_LIGHT);
        submenu.setText(Messages.tr("New Light Here"));
        for (LightType type : TYPES) {
            MenuItem item = items.value(Command.ADD_LIGHT, LightTypes.title(type), () -> {
                if (editor.editOrReport(scene -> LightAtPoint.add(scene, type, picker, hit, canvas)).isEmpty()) {
                    Light added = editor.scene().lights().getLast();
                    editor.selection().selectLight(added.name());
                    picker.findOccluder(hit, added)
                            .ifPresent(
                                    blocker -> editor.message().show(Messages.tr("{0} blocks the light at this point", blocker.shape())));
                }
            });
            item.setGraphic(new FontIcon(LightTypes.icon(type)));
            submenu.getItems().add(item);
        }
        return submenu;
    }

    private MenuItem link(Light light, LightAttribute<ShapeLinks> attribute, String shape, String title) {
        boolean isLinked = LinkEdits.isLinked(editor.scene().stage(), attribute.get(light), shape);
        return items.checkValue(Command.LINK, title, isLinked,
                () -> editor.editOrReport(scene -> LinkEdits.link(scene, light.name(), attribute, shape, !isLinked)));
    }
}
