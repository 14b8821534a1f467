package lightning.editor.window.property;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.TitledPane;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.document.EditOutcome;
import lightning.document.StepRange;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.editor.window.widget.TemperatureSlider;
import lightning.editor.window.widget.VectorField;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.FileAsset;
import lightning.scene.asset.TextureMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Form with a widget for each kind of values. New attributes of a table need no code here.
 *
 * @param <T> type of the element's record
 */
abstract class AttributeForm<T> extends ElementForm<T> {
    /** @param menu  context menu of the properties; null for none */
    AttributeForm(EditorModel model, @Nullable PropertyMenu menu) {
        super(model, menu);
    }

    /** Returns the id of a widget. @param part name of one of several numbers; may be empty */
    String id(SceneAttribute<T, ?> attribute, String part) {
        return part.isEmpty() ? attribute.id() : attribute.id() + " " + part;
    }

    /** Returns the name of an attribute for screen readers and messages. */
    String title(SceneAttribute<T, ?> attribute) {
        return attribute.title();
    }

    /** Returns the visible name, a key of {@link Messages}. @param part name of one of several numbers; may be empty */
    String label(SceneAttribute<T, ?> attribute, String part) {
        return part.isEmpty() ? attribute.title() : part;
    }

    /** Returns the tooltip of a widget, in the interface language; may be empty. */
    String help(SceneAttribute<T, ?> attribute) {
        return attribute.kind() instanceof ValueKind.NameKind kind ? Messages.tr(kind.help()) : "";
    }

    /** Returns a widget with its name: under a caption. */
    List<Node> titled(SceneAttribute<T, ?> attribute, Node widget) {
        return List.of(SectionLayout.caption(SectionLayout.title(label(attribute, ""))), widget);
    }

    /** Returns whether a value is offered. */
    boolean isOffered(Object value, T record) {
        return true;
    }

    /** Sets a chosen value. */
    <V> EditOutcome choose(Scene scene, SceneElement<T> element, SceneAttribute<T, V> attribute, V value) {
        return EditOutcome.edit(scene, element, record -> attribute.with(record, value));
    }

    /** Returns the widgets of an attribute, from top to bottom. They are shown only while {@link #isShown}. */
    final <V> List<Node> rows(SceneAttribute<T, V> attribute) {
        return onlyIf(record -> isShown(attribute, record), switch (attribute.kind()) {
            case NumericKind<V> q -> switch (q.form()) {
                case COLOR -> List.of(color(attribute));
                case POSITION, DIRECTION -> titled(attribute, vector(attribute));
                case INDEPENDENT -> q.unit() == NumberUnit.KELVIN ? titled(attribute, temperature(attribute, q)) : numbers(attribute);
            };
            case ChoiceKind<V> kind -> titled(attribute, choice(attribute, kind));
            case ValueKind.NameKind kind -> titled(attribute, name(cast(attribute, kind)));
            case ValueKind.LinksKind kind -> titled(attribute, links(cast(attribute, kind), kind));
            case ValueKind.GainsKind kind -> titled(attribute, gains(cast(attribute, kind), kind));
            case ValueKind.AssetKind<?> kind -> titled(attribute, file(cast(attribute, kind)));
            case ValueKind.TextureKind kind -> List.of(texture(cast(attribute, kind), kind));
        });
    }

    /** Returns a section with attributes, shown only while one of them is. */
    final TitledPane section(String title, List<? extends SceneAttribute<T, ?>> attributes) {
        TitledPane pane = SectionLayout.section(SectionLayout.title(title),
                attributes.stream().flatMap(attribute -> rows(attribute).stream()).toArray(Node[]::new));
        onlyIf(record -> attributes.stream().anyMatch(attribute -> isShown(attribute, record)), List.of(pane));
        return pane;
    }

    /** Returns the attribute with the type of values of its kind, which the compiler cannot infer. */
    @SuppressWarnings("unchecked")
    private static <T, V> SceneAttribute<T, V> cast(SceneAttribute<T, ?> attribute, ValueKind<V> kind) {
        return (SceneAttribute<T, V>) attribute;
    }

    final Optional<String> edit(UnaryOperator<T> change, @Nullable Object gesture) {
        return selected().flatMap(element -> editor.edit(scene -> EditOutcome.edit(scene, element, change), gesture));
    }

    /** Returns a field for each number of an attribute. */
    final <V> List<Node> numbers(SceneAttribute<T, V> attribute) {
        var quantity = (NumericKind<V>) attribute.kind();
        return IntStream.range(0, quantity.labels().size()).<Node>mapToObj(i -> number(attribute, quantity, i)).toList();
    }

    private <V> ArrowWidget number(SceneAttribute<T, V> attribute, NumericKind<V> quantity, int index) {
        String part = quantity.labels().get(index);
        String title = part.isEmpty() ? title(attribute) : title(attribute) + " " + part;
        var widget = new ArrowWidget(SectionLayout.title(label(attribute, part)), title,
                NumberSetting.of(title, StepRange.of(quantity), quantity.unit(), (number, gesture) -> edit(record -> {
                    quantity.check(title, number);
                    return attribute.with(record, quantity.with(attribute.get(record), index, number));
                }, gesture)));
        widget.setId(id(attribute, part));
        return add(attribute, widget, record -> quantity.number(attribute.get(record), index));
    }

    private <V> TemperatureSlider temperature(SceneAttribute<T, V> attribute, NumericKind<V> quantity) {
        var slider = new TemperatureSlider((kelvin, gesture) -> edit(record -> attribute.with(record, quantity.of(kelvin)), gesture));
        slider.setId(id(attribute, ""));
        return add(attribute, slider, record -> quantity.number(attribute.get(record), 0));
    }

    /** Returns a field for three numbers. */
    final <V> VectorField vector(SceneAttribute<T, V> attribute) {
        var quantity = (NumericKind<V>) attribute.kind();
        var field = new VectorField(title(attribute),
                (v, gesture) -> edit(record -> attribute.with(record, quantity.of(v.x(), v.y(), v.z())), gesture));
        field.setId(id(attribute, ""));
        return add(attribute, field, record -> quantity.vector(attribute.get(record)));
    }

    /** Returns sliders for a color. */
    final <V> ColorSliders color(SceneAttribute<T, V> attribute) {
        var quantity = (NumericKind<V>) attribute.kind();
        var sliders = new ColorSliders(Messages.tr(title(attribute)), help(attribute), quantity.max(), (change, gesture) -> edit(record -> {
            Rgb color = change.apply(quantity.color(attribute.get(record)));
            return attribute.with(record, quantity.of(color.r(), color.g(), color.b()));
        }, gesture));
        sliders.setId(id(attribute, ""));
        return add(attribute, sliders, record -> quantity.color(attribute.get(record)));
    }

    /** Returns a check box. */
    final CheckField check(SceneAttribute<T, Boolean> attribute) {
        return add(attribute, new CheckField(id(attribute, ""), SectionLayout.title(label(attribute, "")), help(attribute),
                on -> choose(attribute, on)), attribute::get);
    }

    private <V> ChoiceField<V> choice(SceneAttribute<T, V> attribute, ChoiceKind<V> kind) {
        return choice(attribute, value -> kind.values().stream()
                .filter(v -> v.equals(value) || record().filter(record -> !isOffered(v, record)).isEmpty()).toList(),
                value -> SectionLayout.title(kind.label(value)));
    }

    /** Returns a box of names of the scene, and none. */
    final ChoiceField<String> name(SceneAttribute<T, String> attribute) {
        var kind = (ValueKind.NameKind) attribute.kind();
        return choice(attribute, _ -> Stream.concat(Stream.of(""), editor.scene().names(kind.referent()).stream()).toList(),
                name -> name.isEmpty() ? Messages.tr("none") : name);
    }

    /** Returns a box of values. @param offered as in {@link ChoiceField} */
    final <V> ChoiceField<V> choice(SceneAttribute<T, V> attribute, Function<@Nullable V, List<V>> offered, Function<V, String> text) {
        return add(attribute, new ChoiceField<>(id(attribute, ""), Messages.tr(title(attribute)), help(attribute), offered, text,
                value -> choose(attribute, value)), attribute::get);
    }

    private <V> void choose(SceneAttribute<T, V> attribute, V value) {
        selected().ifPresent(element -> editor.editOrReport(scene -> choose(scene, element, attribute, value)));
    }

    private LinksField links(SceneAttribute<T, ShapeLinks> attribute, ValueKind.LinksKind kind) {
        return add(attribute, new LinksField(model, id(attribute, ""), Messages.tr(title(attribute)), Messages.tr(kind.help()),
                change -> edit(record -> attribute.with(record, change.apply(attribute.get(record))), null)
                        .ifPresent(editor.message()::show)),
                attribute::get);
    }

    private GainsField gains(SceneAttribute<T, ShapeGains> attribute, ValueKind.GainsKind kind) {
        return add(attribute, new GainsField(model.commands(), id(attribute, ""), Messages.tr(title(attribute)), Messages.tr(kind.help())),
                attribute::get);
    }

    /** Returns a menu of files. */
    final <F extends FileAsset> FileField<F> file(SceneAttribute<T, Optional<F>> attribute) {
        return add(attribute, new FileField<>(model, id(attribute, ""), Messages.tr(title(attribute)),
                FileChoice.of((ValueKind.AssetKind<?>) attribute.kind()),
                () -> fileSetter(attribute, refusal -> refusal.ifPresent(editor.message()::show))), attribute::get);
    }

    private TextureField texture(SceneAttribute<T, Optional<TextureMap>> attribute, ValueKind.TextureKind kind) {
        List<Node> placement = kind.placement(attribute).stream().flatMap(placed -> rows(placed).stream()).toList();
        return add(attribute,
                new TextureField(model, id(attribute, ""), title(attribute), placement, report -> fileSetter(attribute, report)),
                attribute::get);
    }

    /** Returns what sets a file of the element that is selected now. It ignores a file that is chosen after another selection. */
    private <F> Consumer<String> fileSetter(SceneAttribute<T, Optional<F>> attribute, Consumer<Optional<String>> report) {
        Optional<SceneElement<T>> element = selected();
        return file -> element.filter(_ -> selected().equals(element)).ifPresent(e -> setFile(e, attribute, file, report));
    }

    /** Reads a file in the background, and sets it in the scene as it is then. Reports why it cannot be used. */
    private <F> void setFile(SceneElement<T> element, SceneAttribute<T, Optional<F>> attribute, String file,
            Consumer<Optional<String>> report) {
        if (file.isEmpty()) {
            report.accept(editor.edit(scene -> EditOutcome.edit(scene, element, attribute::reset)));
            return;
        }
        Scene scene = editor.scene();
        Path folder = model.fileImporter().folder();
        model.fileImporter().files().runConcurrently(
                () -> EditOutcome.of(() -> PropertyEdit.setFile(scene, element, attribute.name(), file, folder)),
                loaded -> report.accept(loaded.refusal().or(() -> editor.edit(now -> EditOutcome.edit(now, element,
                        record -> attribute.copy(element.get(loaded.sceneOr(scene)), record))))),
                failure -> report.accept(Optional.of(ErrorMessage.of(failure))));
    }
}
