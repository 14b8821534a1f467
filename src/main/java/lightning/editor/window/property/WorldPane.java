package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Priority;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ViewActions;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.render.image.DisplayCurve;
import lightning.scene.Dome;
import lightning.scene.FogAttributes;
import lightning.scene.SceneElement;
import lightning.scene.SkyAttributes;
import lightning.scene.World;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.sky.SkyUnit;

/** Properties of the scene as a whole: ambient light, background, environments, fog, indirect light, the camera's lens and view. */
final class WorldPane extends AttributeForm<World> {
    /** Lengths of a new box of fog, scene units. */
    private static final Vec3 NEW_BOX = new Vec3(10, 10, 10);
    /** Beginnings of titles that the section says. */
    private static final List<String> PREFIXES = List.of("environment ", "fog ");

    private static final SceneAttribute<World, Boolean> NITS = new SceneAttribute<>("sky_nits", SkyAttributes.UNIT.title(),
            ChoiceKind.YES_OR_NO, false, "", world -> world.sky().unit() == SkyUnit.NIT,
            (world, on) -> SkyAttributes.UNIT.with(world, on ? SkyUnit.NIT : SkyUnit.RELATIVE));
    private static final SceneAttribute<World, Boolean> BOX = new SceneAttribute<>("fog_box", FogAttributes.SIZE.title(),
            ChoiceKind.YES_OR_NO, false, "", world -> world.fog().hasBox(),
            (world, on) -> FogAttributes.SIZE.with(world, on ? NEW_BOX : Vec3.ZERO));

    private static final Map<SceneAttribute<World, ?>, String> LABELS = Map.of(World.BACKGROUND, Messages.key("Background"),
            World.SOLO, Messages.key("Solo"), SkyAttributes.ON, Messages.key("Physical Sky"), NITS, Messages.key("Brightness in Nits"),
            SkyAttributes.GROUND, Messages.key("Ground Color"), FogAttributes.COLOR, Messages.key("Fog Color"), FogAttributes.AMBIENT,
            Messages.key("Fog Ambient Light"), BOX, Messages.key("Only in a Box"));
    private static final Map<SceneAttribute<World, ?>, String> HELP = Map.of(World.BACKGROUND,
            Messages.key("Color behind the scene, also seen in reflections"), World.SOLO,
            Messages.key("Mute all lights that are not solo"), SkyAttributes.ON,
            Messages.key("Clear sky with a sun as the environment, instead of an image"), NITS,
            Messages.key("For lights with photometric units; otherwise a value of 1 is 10 000 nits"), SkyAttributes.GROUND,
            Messages.key("Share of the light that the ground reflects"), FogAttributes.COLOR,
            Messages.key("Share of the light that the fog scatters"), FogAttributes.AMBIENT,
            Messages.key("Light that comes from all sides"), BOX, Messages.key("Fog in a box instead of everywhere"));

    private final ArrowWidget exposure;

    /** @param tabSelected  true while the pane is visible; it is updated only then */
    WorldPane(EditorModel model, ObservableValue<Boolean> tabSelected) {
        super(model, null);
        ObservableValue<EditorState> visibleState = editor.editorStateProperty().when(tabSelected);
        ViewActions views = model.viewActions();
        setId("world");
        getStyleClass().add("properties");
        exposure = new ArrowWidget(Messages.tr("Exposure"), "exposure",
                NumberSetting.of("exposure", ViewActions.EXPOSURE_RANGE, NumberUnit.STOPS, views::setExposure));
        exposure.setId("world-exposure");
        var curve = new ChoiceField<>("world-curve", Messages.tr("View Transform"), "", _ -> List.of(DisplayCurve.values()),
                shown -> Messages.tr(shown.title()), views::setCurve);
        CommandButton lut = CommandButton.titledButton(model.commands(), Command.COLOR_TABLE);
        lut.button().setMaxWidth(Double.MAX_VALUE);
        ScrollPane scroll = SectionLayout.scroll(
                SectionLayout.section(Messages.tr("Environment"), environment(visibleState)),
                SectionLayout.section(Messages.tr("Domes"), new DomeForm(model, visibleState)),
                SectionLayout.section(Messages.tr("Fog"), fog()),
                SectionLayout.section(Messages.tr("Indirect Light"), new IndirectForm(model, visibleState)),
                SectionLayout.section(Messages.tr("Camera"), new NamedCameraField(editor, visibleState),
                        CameraForm.view(model, visibleState)),
                SectionLayout.section(Messages.tr("Depth of Field"), CameraForm.lens(model, visibleState)),
                SectionLayout.section(Messages.tr("View"), SectionLayout.caption(Messages.tr("View Transform")), curve, exposure, lut));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        showWhile(visibleState);
        views.viewProperty().subscribe(view -> {
            curve.show(view.curve());
            exposure.show(view.exposure());
        });
    }

    private Node[] environment(ObservableValue<EditorState> visibleState) {
        return SectionLayout.nodes(
                onlyIf(world -> !world.sky().on(), List.of(file(World.ENVIRONMENT))),
                List.of(check(SkyAttributes.ON)),
                columnIf(world -> world.sky().on(), numbers(SkyAttributes.ALL), List.of(new SunPlacePane(editor)),
                        titledColor(SkyAttributes.GROUND), List.of(check(NITS))),
                List.of(new EnvironmentPicture(editor, visibleState)),
                columnIf(world -> world.environment().isPresent(), numbers(World.OWN), List.of(check(World.SOLO))),
                numbers(World.AMBIENCE),
                columnIf(world -> world.environments().stream().noneMatch(Dome::on), titledColor(World.BACKGROUND)),
                numbers(World.METERS));
    }

    private Node[] fog() {
        List<SceneAttribute<World, ?>> numbers = new ArrayList<>(FogAttributes.ALL);
        numbers.removeAll(List.of(FogAttributes.DENSITY, FogAttributes.SIZE));
        return SectionLayout.nodes(numbers(FogAttributes.DENSITY),
                columnIf(world -> world.fog().isPresent(), titledColor(FogAttributes.COLOR), numbers(numbers),
                        titledColor(FogAttributes.AMBIENT), List.of(check(BOX)),
                        columnIf(world -> world.fog().hasBox(), numbers(FogAttributes.CENTER), numbers(FogAttributes.SIZE))));
    }

    /** Returns fields for the single numbers of a table. */
    private List<Node> numbers(List<SceneAttribute<World, ?>> table) {
        return table.stream().filter(a -> a.kind() instanceof NumericKind<?> kind && kind.form() == NumericKind.Form.INDEPENDENT)
                .flatMap(a -> numbers(a).stream()).toList();
    }

    private List<Node> titledColor(SceneAttribute<World, Rgb> attribute) {
        return titled(attribute, color(attribute));
    }

    @Override
    Optional<SceneElement<World>> selected() {
        return Optional.of(SceneElement.WORLD);
    }

    @Override
    String missingReason() {
        throw new IllegalStateException("each scene has a world");
    }

    @Override
    void revert() {
        super.revert();
        exposure.revert();
    }

    @Override
    String id(SceneAttribute<World, ?> attribute, String part) {
        boolean isNumber = attribute.kind() instanceof NumericKind<?> kind && kind.form() != NumericKind.Form.COLOR;
        String id = isNumber ? attribute.id() + (part.isEmpty() ? "" : " " + part)
                : attribute == World.ENVIRONMENT ? attribute.id() : "world-" + attribute.name();
        return id.replace(' ', '-').replace('_', '-');
    }

    @Override
    String label(SceneAttribute<World, ?> attribute, String part) {
        String title = LABELS.getOrDefault(attribute, attribute.title()) + (part.isEmpty() ? "" : " " + part);
        return PREFIXES.stream().filter(title::startsWith).findFirst().map(prefix -> title.substring(prefix.length())).orElse(title);
    }

    @Override
    String help(SceneAttribute<World, ?> attribute) {
        return Optional.ofNullable(HELP.get(attribute)).map(Messages::tr).orElse("");
    }
}
