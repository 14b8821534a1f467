package lightning.sample;

import java.util.List;
import java.util.Optional;
import lightning.scene.World;
import lightning.scene.light.LightAttribute;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary edits of every kind that the dispatcher supports. */
public final class EditArbitraries {
    private EditArbitraries() {}

    /** Returns sequences of one to twelve edits. */
    public static Arbitrary<List<Edit>> sequences() {
        return edits().list().ofMinSize(1).ofMaxSize(12);
    }

    /** Returns sequences of one to twelve edits of light intensity and falloff. */
    static Arbitrary<List<Edit>> scaleSequences() {
        Arbitrary<Edit> edits = Combinators.combine(lights(), scales()).as(Edit.EditLight::new);
        return edits.list().ofMinSize(1).ofMaxSize(12);
    }

    private static Arbitrary<LightChange> scales() {
        return Arbitraries.oneOf(List.of(
                LightArbitraries.colors().map(LightChange.Color::new),
                LightArbitraries.intensities().map(LightChange.Intensity::new),
                LightArbitraries.attenuations().map(LightChange.SetAttenuation::new),
                LightArbitraries.dropoffs().map(LightChange.Dropoff::new)));
    }

    static Arbitrary<Edit> edits() {
        return Arbitraries.frequencyOf(Tuple.of(9, singleEdits()),
                Tuple.of(1, singleEdits().list().ofMinSize(2).ofMaxSize(4).map(Edit.CompositeEdit::new)));
    }

    private static Arbitrary<Edit> singleEdits() {
        return Arbitraries.frequencyOf(
                Tuple.of(24, lightEdits()),
                Tuple.of(14, materialEdits()),
                Tuple.of(8, lightListEdits()),
                Tuple.of(5, lightGroupEdits()),
                Tuple.of(6, worldEdits()),
                Tuple.of(4, Arbitraries.integers().between(1, 6).map(Edit.Undo::new)),
                Tuple.of(8, shapeEdits()),
                Tuple.of(1, geometryEdits()));
    }

    private static Arbitrary<Edit> lightEdits() {
        return Combinators.combine(lights(), changes()).as(Edit.EditLight::new);
    }

    private static Arbitrary<LightChange> changes() {
        return Arbitraries.oneOf(List.of(
                LightArbitraries.colors().map(LightChange.Color::new),
                LightArbitraries.intensities().map(LightChange.Intensity::new),
                LightArbitraries.attenuations().map(LightChange.SetAttenuation::new),
                LightArbitraries.angles().map(LightChange.Angle::new),
                LightArbitraries.angles().map(LightChange.Angle::new),
                LightArbitraries.dropoffs().map(LightChange.Dropoff::new),
                LightArbitraries.doors().map(d -> new LightChange.SetAttribute<>(LightAttribute.DOORS, d)),
                LightArbitraries.beams().flatMap(b -> Arbitraries.of(new LightChange.SetAttribute<>(LightAttribute.CONE, b.cone()),
                        new LightChange.SetAttribute<>(LightAttribute.CONE_SOFTNESS, b.softness()),
                        new LightChange.SetAttribute<>(LightAttribute.BEAM_SPREAD, b.spread()))),
                LightArbitraries.flags().flatMap(f -> Arbitraries.of(new LightChange.SetAttribute<>(LightAttribute.FLAG, f.on()),
                        new LightChange.SetAttribute<>(LightAttribute.FLAG_POSITION, f.position()),
                        new LightChange.SetAttribute<>(LightAttribute.FLAG_WIDTH, f.width()),
                        new LightChange.SetAttribute<>(LightAttribute.FLAG_SOFTNESS, f.softness()),
                        new LightChange.SetAttribute<>(LightAttribute.FLAG_DENSITY, f.density()))),
                LightArbitraries.filters().flatMap(f -> Arbitraries.of(new LightChange.SetAttribute<>(LightAttribute.FILTER, f.shape()),
                        new LightChange.SetAttribute<>(LightAttribute.FILTER_POSITION, f.position()),
                        new LightChange.SetAttribute<>(LightAttribute.FILTER_SIZE, f.size()),
                        new LightChange.SetAttribute<>(LightAttribute.FILTER_DENSITY, f.density()),
                        new LightChange.SetAttribute<>(LightAttribute.FILTER_INVERTED, f.inverted()))),
                LightArbitraries.gobos().map(g -> new LightChange.SetAttribute<>(LightAttribute.GOBO, g)),
                LightArbitraries.textures().map(t -> new LightChange.SetAttribute<>(LightAttribute.TEXTURE, t)),
                LightArbitraries.profiles().map(p -> new LightChange.SetAttribute<>(LightAttribute.PROFILE, p)),
                LightArbitraries.feathers().map(f -> new LightChange.SetAttribute<>(LightAttribute.FEATHER, f)),
                LightArbitraries.links().map(l -> new LightChange.SetAttribute<>(LightAttribute.ILLUMINATES, l)),
                LightArbitraries.links().map(l -> new LightChange.SetAttribute<>(LightAttribute.ILLUMINATES, l)),
                LightArbitraries.links().map(l -> new LightChange.SetAttribute<>(LightAttribute.SHADOWED_BY, l)),
                LightArbitraries.links().map(l -> new LightChange.SetAttribute<>(LightAttribute.SHADOWED_BY, l)),
                LightArbitraries.types().map(LightChange.Type::new),
                LightArbitraries.areas().map(LightChange.SetArea::new),
                Arbitraries.of(new LightChange.ToggleOn()),
                Arbitraries.of(new LightChange.ToggleOn()),
                Arbitraries.of(new LightChange.ToggleSolo()),
                LightArbitraries.places().map(LightChange.Move::new),
                LightArbitraries.aimPositions().map(LightChange.Turn::new),
                Arbitraries.of(0.5, 2.0, 1e3).map(LightChange.ScaleDirection::new),
                AttributeArbitraries.lightChanges()));
    }

    private static Arbitrary<Edit> materialEdits() {
        return Arbitraries.frequencyOf(
                Tuple.of(12, Combinators.combine(Arbitraries.integers().between(0, 3).withoutEdgeCases(), MaterialArbitraries.changes())
                        .as(Edit.EditMaterial::new)),
                Tuple.of(1, Arbitraries.of(new Edit.AddUnusedMaterial())),
                Tuple.of(1, MaterialArbitraries.changes().map(Edit.OverrideDefaultMaterial::new)));
    }

    private static Arbitrary<Edit> lightListEdits() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(lights(), LightArbitraries.lights()).as(Edit.AddLight::new),
                Combinators.combine(lights(), lights()).as(Edit.DuplicateLight::new),
                lights().map(Edit.DeleteLight::new),
                lights().map(Edit.RenameLight::new),
                Combinators.combine(lights(), lights()).as(Edit.SwapLightNames::new),
                Combinators.combine(lights(), lights()).as(Edit.ReorderLights::new)));
    }

    private static Arbitrary<Edit> lightGroupEdits() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(lights(), Arbitraries.integers().between(0, 2)).as(Edit.AssignLightGroup::new),
                Combinators.combine(lights(), LightArbitraries.lightGroupNames("fresh")).as(Edit.EditLightGroup::new),
                Combinators.combine(lights(), LightArbitraries.lightGroupNames("fresh")).as(Edit.EditLightGroup::new),
                lights().map(Edit.DeleteLightGroup::new),
                lights().map(Edit.RenameLightGroup::new)));
    }

    static Arbitrary<Edit> worldEdits() {
        return Arbitraries.oneOf(List.of(
                NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 1e6).map(v -> new Edit.EditWorld<>(World.AMBIENCE, v)),
                NumberArbitraries.colors().map(v -> new Edit.EditWorld<>(World.BACKGROUND, v)),
                SceneArbitraries.environmentMaps().map(s -> new Edit.SetEnvironment(Optional.of(s))),
                Arbitraries.of(new Edit.SetEnvironment(Optional.empty())),
                SceneArbitraries.rotations().map(v -> new Edit.EditWorld<>(World.ROTATION, v)),
                SceneArbitraries.tilts().map(v -> new Edit.EditWorld<>(World.TILT, v)),
                SceneArbitraries.tilts().map(v -> new Edit.EditWorld<>(World.ROLL, v)),
                SceneArbitraries.softnesses().map(v -> new Edit.EditWorld<>(World.SOFTNESS, v)),
                NumberArbitraries.rangeOrSpecial(0, 2, 0.0, 1.0).map(v -> new Edit.EditWorld<>(World.INTENSITY, v)),
                SceneArbitraries.environmentGains().map(v -> new Edit.EditWorld<>(World.GAIN, v)),
                Arbitraries.of(true, false).map(v -> new Edit.EditWorld<>(World.SOLO, v)),
                DomeArbitraries.edits(), DomeArbitraries.edits(),
                FogArbitraries.edits(), FogArbitraries.edits(), SkyArbitraries.edits(),
                SceneArbitraries.depths().map(Edit.SetDepth::new),
                SceneArbitraries.depths().map(Edit.SetDepth::new)));
    }

    private static Arbitrary<Edit> geometryEdits() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(sides(), sides()).as(Edit.Resize::new),
                SceneArbitraries.samplings().map(Edit.SetSampling::new),
                NumberArbitraries.range(-0.3, 0.3).map(Edit.OrbitCamera::new),
                SceneArbitraries.lenses().map(Edit.SetLens::new),
                nodes().map(Edit.RemoveNode::new),
                Combinators.combine(nodes(), Arbitraries.of(NodeArbitraries.MATERIALS)).as(Edit.AssignMaterial::new)));
    }

    /** Returns edits of objects and their materials; some undo earlier ones, some move a light. */
    static Arbitrary<Edit> objectEdits() {
        return Arbitraries.frequencyOf(
                Tuple.of(10, shapeEdits()),
                Tuple.of(3, materialEdits()),
                Tuple.of(1, Combinators.combine(nodes(), Arbitraries.of(NodeArbitraries.MATERIALS)).as(Edit.AssignMaterial::new)),
                Tuple.of(1, SceneArbitraries.depths().map(Edit.SetDepth::new)),
                Tuple.of(2, lightEdits()),
                Tuple.of(3, Arbitraries.integers().between(1, 4).map(Edit.Undo::new)));
    }

    private static Arbitrary<Edit> shapeEdits() {
        return Arbitraries.frequencyOf(
                Tuple.of(10, Combinators.combine(nodes(), NodeArbitraries.changes()).as(Edit.EditNode::new)),
                Tuple.of(1, nodes().map(Edit.RemoveNode::new)),
                Tuple.of(1, Combinators.combine(nodes(), nodes()).as(Edit.DuplicateNode::new)),
                Tuple.of(1, Combinators.combine(nodes(), nodes()).as(Edit.SwapNodes::new)),
                Tuple.of(2, Combinators.combine(nodes(), Arbitraries.of(true, false)).as(Edit.GroupNode::new)));
    }

    private static Arbitrary<Integer> nodes() {
        return Arbitraries.integers().between(0, 12).withoutEdgeCases();
    }

    private static Arbitrary<Integer> sides() {
        return Arbitraries.integers().between(8, 40).withoutEdgeCases();
    }

    private static Arbitrary<Integer> lights() {
        return Arbitraries.integers().between(0, 6).withoutEdgeCases();
    }
}
