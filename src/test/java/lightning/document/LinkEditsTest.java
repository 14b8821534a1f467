package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.From;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LinkEditsTest {
    private static final Stage STAGE = new Stage(List.of(), List.of(shape("floor"),
            group("head", shape("nose"), group("eyes", shape("left"), shape("right")), group("hat"))));
    private static final List<String> NAMES = List.of("floor", "head", "nose", "eyes", "left", "right", "hat");

    private static SceneNode shape(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static SceneNode group(String name, SceneNode... children) {
        return new NodeGroup(name, Placement.IDENTITY, List.of(children), true);
    }

    private static Scene scene(ShapeLinks links) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, STAGE,
                LightRig.of(List.of(Light.of("key", LightType.POINT).withIlluminates(links))));
    }

    @Provide
    Arbitrary<ShapeLinks> links() {
        return Combinators.combine(Arbitraries.of(true, false), Arbitraries.of(NAMES).list().ofMaxSize(5)).as(ShapeLinks::new);
    }

    @Provide
    Arbitrary<String> names() {
        return Arbitraries.of(NAMES);
    }

    /** An edit changes exactly the shapes of its object, whatever names the links had. */
    @Property(tries = 400)
    void link_changesOnlyItsObject(@ForAll("links") ShapeLinks links, @ForAll @From("names") String node, @ForAll boolean linked) {
        Light edited = LinkEdits.link(scene(links), "key", LightAttribute.ILLUMINATES, node, linked).sceneOr(null).lights().getFirst();
        boolean[] expected = STAGE.linkMask(links).clone();
        boolean[] inside = STAGE.linkMask(ShapeLinks.only(node));
        for (int s = 0; s < expected.length; s++) {
            expected[s] = inside[s] ? linked : expected[s];
        }
        assertThat(STAGE.linkMask(edited.illuminates())).as(edited.illuminates().format()).isEqualTo(expected);
    }

    /** The table shows what the renderer does. */
    @Property(tries = 400)
    void table_showsStatesOfAllRows(@ForAll("links") ShapeLinks links) {
        Scene scene = scene(links);
        boolean[] mask = STAGE.linkMask(links);
        for (LinkTable.Row row : LinkTable.of(scene, Set.of(), "").rows()) {
            boolean[] inside = STAGE.linkMask(ShapeLinks.only(row.name()));
            List<Boolean> linked = new ArrayList<>();
            for (int s = 0; s < mask.length; s++) {
                if (inside[s]) {
                    linked.add(mask[s]);
                }
            }
            if (!linked.isEmpty() && !containsEmptyGroup(row)) {
                assertThat(LinkTable.link(scene.lights().getFirst(), row).state()).as(row.name()).isEqualTo(
                        !linked.contains(false) ? LinkTable.State.ON : linked.contains(true) ? LinkTable.State.MIXED : LinkTable.State.OFF);
            }
        }
    }

    private static boolean containsEmptyGroup(LinkTable.Row row) {
        return row.name().equals("head");
    }

    @Test
    void unlinkedObjectOfLinkedGroup_leavesItsSiblingsLinked() {
        Light edited = LinkEdits.link(scene(ShapeLinks.only("head")), "key", LightAttribute.ILLUMINATES, "left", false).sceneOr(null)
                .lights().getFirst();
        assertThat(edited.illuminates().names()).containsExactlyInAnyOrder("nose", "hat", "right");
    }

    @Test
    void gain_isNamedSetAndReset() {
        EditOutcome outcome = LinkEdits.setGain(scene(ShapeLinks.except("left")), "key", "left", 0.3, false);
        assertThat(((EditOutcome.Applied) outcome).label()).isEqualTo("Gain of key on left");
        Light edited = outcome.sceneOr(null).lights().getFirst();
        assertThat(edited.influence().gains()).isEqualTo(ShapeGains.of("left", 0.3));
        assertThat(edited.illuminates()).isEqualTo(ShapeLinks.ALL);
        Scene both = LinkEdits.setGain(outcome.sceneOr(null), "key", "head", 0.5, false).sceneOr(null);
        assertThat(gains(LinkEdits.resetGain(both, "key", "left"))).isEqualTo(ShapeGains.of("head", 0.5));
        assertThat(gains(LinkEdits.resetGain(both, "key", "head"))).isEqualTo(ShapeGains.NONE);
    }

    @Test
    void gainOfPartlyLinkedGroup_keepsItsLinks() {
        EditOutcome outcome = LinkEdits.setGain(scene(ShapeLinks.except("left")), "key", "head", 0.3, false);
        assertThat(outcome.sceneOr(null).lights().getFirst().illuminates()).isEqualTo(ShapeLinks.except("left"));
    }

    /** A gain that the object has anyway is stored only during a drag, so that a drag through it changes no rows. */
    @Test
    void redundantGain_isRemoved() {
        Scene scene = LinkEdits.setGain(scene(ShapeLinks.ALL), "key", "head", 0.5, false).sceneOr(null);
        assertThat(gains(LinkEdits.setGain(scene, "key", "left", 0.5, false))).isEqualTo(ShapeGains.of("head", 0.5));
        assertThat(gains(LinkEdits.setGain(scene, "key", "left", 0.5, true)).names()).containsExactly("head", "left");
        assertThat(gains(LinkEdits.setGain(scene, "key", "left", 1, false)).names()).containsExactly("head", "left");
        assertThat(gains(LinkEdits.setGain(scene, "key", "head", 1, false))).isEqualTo(ShapeGains.NONE);
    }

    private static ShapeGains gains(EditOutcome outcome) {
        return outcome.sceneOr(null).lights().getFirst().influence().gains();
    }

    @Test
    void table_hasRowsOfOpenGroupsAndMatches() {
        Scene scene = LinkEdits.setGain(scene(ShapeLinks.ALL), "key", "eyes", 0.5, false).sceneOr(null);
        Light key = scene.lights().getFirst();
        assertThat(LinkTable.of(scene, Set.of("eyes"), "").rows()).extracting(LinkTable.Row::name)
                .containsExactly("floor", "head", "nose", "eyes", "hat");
        List<LinkTable.Row> found = LinkTable.of(scene, Set.of("eyes"), "LEF").rows();
        assertThat(found).extracting(LinkTable.Row::name).containsExactly("left");
        assertThat(LinkTable.link(key, found.getFirst())).isEqualTo(new LinkTable.Link(LinkTable.State.ON, 0.5, false, false));
        assertThat(LinkTable.link(key, found.getFirst()).describe()).isEqualTo("50 %, from its group");
        LinkTable.Row head = LinkTable.of(scene, Set.of(), "").rows().get(1);
        assertThat(LinkTable.link(key, head).describe()).isEqualTo("100 %, other gains inside");
    }
}
