package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.Priority;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightAttribute.Section;
import lightning.scene.light.LightType;

/** Property editor of the selected light (paper §3.2, Figure 5). */
public final class PropertyPane extends AttributeForm<Light> {
    private final LightHeader header;

    /**
     * @param menu  context menu of the properties
     * @param tabSelected  true while the pane is visible; a hidden pane only discards uncommitted input of another light
     */
    PropertyPane(EditorModel model, PropertyMenu menu, ObservableValue<Boolean> tabSelected) {
        super(model, menu);
        setId("properties");
        getStyleClass().add("properties");
        header = new LightHeader(editor, model.commands());
        ObservableValue<EditorState> visibleState = editor.editorStateProperty().when(tabSelected);
        var group = new LightGroupForm(model, name(LightAttribute.LIGHT_GROUP), visibleState);
        ScrollPane scroll = SectionLayout.scroll(Stream.of(Stream.of(header),
                Stream.of(Section.COLOR, Section.CONE, Section.AREA, Section.ATTENUATION, Section.PLACE, Section.FILTERS,
                        Section.CONTRIBUTION, Section.LINKS).map(this::section),
                Stream.of(SectionLayout.section(Messages.tr("Light Group"), group))).flatMap(s -> s).toArray(Node[]::new));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        showWhile(visibleState);
    }

    private TitledPane section(Section section) {
        TitledPane pane = section(section.title(), LightAttribute.ALL.stream().filter(a -> a.section() == section).toList());
        if (section == Section.PLACE) {
            CommandButton aim = CommandButton.titledButton(model.commands(), Command.AIM);
            aim.button().setMaxWidth(Double.MAX_VALUE);
            SectionLayout.content(pane).getChildren().add(aim);
        }
        return pane;
    }

    @Override
    Optional<SceneElement<Light>> selected() {
        return Optional.ofNullable(editor.selection().light()).map(light -> new SceneElement.OfLight(light.name()));
    }

    /** A renamed light is the same. */
    @Override
    Object owner() {
        return List.of(editor.document(), editor.document().history().id(editor.selection().lightName()));
    }

    @Override
    void revert() {
        super.revert();
        header.revert();
    }

    @Override
    String missingReason() {
        return Messages.tr("no light is selected");
    }

    /** A directional light keeps its position, where its gizmo is drawn. */
    @Override
    Optional<String> inactiveReason(SceneAttribute<Light, ?> attribute, Light light) {
        return attribute == LightAttribute.POSITION ? Optional.empty() : attribute.inactiveReason(light);
    }

    @Override
    boolean isShown(SceneAttribute<Light, ?> attribute, Light light) {
        return attribute == LightAttribute.POSITION && light.type() != LightType.OBJECT || attribute.inactiveReason(light).isEmpty()
                && (attribute != LightAttribute.SAMPLES && attribute != LightAttribute.VISIBLE || light.hasSamples());
    }

    @Override
    String id(SceneAttribute<Light, ?> attribute, String part) {
        return switch (attribute.kind()) {
            case ValueKind.NameKind _,ValueKind.LightTextureKind _ -> "light-" + attribute.name();
            case ValueKind.LinksKind _ -> attribute.name();
            default -> part.isEmpty() ? attribute.id() : part;
        };
    }

    /** The color needs no name: it is that of the light. */
    @Override
    String title(SceneAttribute<Light, ?> attribute) {
        return attribute == LightAttribute.COLOR ? "" : attribute.title();
    }

    @Override
    String label(SceneAttribute<Light, ?> attribute, String part) {
        // A section that has the attribute's name says the rest.
        boolean isSection = ((LightAttribute<?>) attribute).section().title().equals(attribute.title());
        return attribute.kind() instanceof ValueKind.LinksKind kind ? kind.caption()
                : part.isEmpty() ? attribute.title() : isSection ? part : attribute.title() + " " + part;
    }

    @Override
    String help(SceneAttribute<Light, ?> attribute) {
        return attribute == LightAttribute.COLOR ? Messages.tr("Light color") : super.help(attribute);
    }

    @Override
    boolean isOffered(Object value, Light light) {
        return !(value instanceof IntensityUnit unit) || unit.isUsualFor(light);
    }

    @Override
    <V> EditOutcome choose(Scene scene, SceneElement<Light> element, SceneAttribute<Light, V> attribute, V value) {
        return LightEdits.setChoice(scene, element.name(), attribute, value);
    }
}
