package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Transform;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.FrameTracks;
import lightning.format.exchange.assembly.NearestAngles;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.Track;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Converter of a stage's prims to groups and shapes; instances share their meshes. */
final class UsdNodes {
    /** Groups inside each other; deeper ones dissolve. Two more are left for a shear and for the parts of a mesh. */
    private static final int MAX_GROUPS = SceneLimits.MAX_NESTING - 4;
    /** Prims inside each other. */
    private static final int MAX_DEPTH = 500;
    private static final int PROTOTYPE = -2;

    private final SceneAssembler assembler;
    private final UsdStage stage;
    private final Transform upright;
    private final int firstFrame;
    private final JsonValue nodes;
    private final List<List<Integer>> children = new ArrayList<>();
    private final List<Integer> roots = new ArrayList<>();
    private final Map<Integer, String> names = new HashMap<>();
    private final List<Track> tracks = new ArrayList<>();
    private final UsdParts parts;
    private final Progress progress;
    private boolean[] shows = {};
    private long visits;

    UsdNodes(SceneAssembler assembler, UsdStage stage, Transform upright, int firstFrame, int levels, Progress progress)
            throws MeshException {
        this.assembler = assembler;
        this.stage = stage;
        this.upright = upright;
        this.firstFrame = firstFrame;
        nodes = stage.root().get("nodes");
        this.progress = progress;
        parts = new UsdParts(assembler, stage, levels, progress);
    }

    /** Adds all nodes to the scene. */
    void build() throws IOException, MeshException {
        for (int i = 0; i < nodes.size(); i++) {
            children.add(new ArrayList<>());
            int parent = nodes.element(i).get("parent").integer(PROTOTYPE, i - 1);
            if (parent >= 0) {
                children.get(parent).add(i);
            } else if (parent != PROTOTYPE) {
                roots.add(i);
            }
        }
        parts.read(nodes);
        shows = new boolean[nodes.size()];
        for (int i = nodes.size() - 1; i >= 0; i--) {
            JsonValue in = nodes.element(i);
            shows[i] = in.get("instances").isPresent() || parts.count(in) > 0 || children.get(i).stream().anyMatch(child -> shows[child]);
        }
        for (int i : roots) {
            assembler.nodes.addAll(build(i, Transform.IDENTITY, upright, 0, 0, true));
        }
    }

    List<Track> tracks() {
        return tracks;
    }

    /** Returns the names of a node; of what is inside if it is no group itself. */
    List<String> names(int node) {
        if (names.containsKey(node)) {
            return List.of(names.get(node));
        }
        List<String> result = new ArrayList<>();
        for (int child : children.get(node)) {
            result.addAll(names(child));
        }
        return result;
    }

    /**
     * Returns the nodes of a prim with all inside; empty if it shows nothing.
     *
     * @param world transform of the innermost group around it
     * @param pending transform from the prim's parent to that group
     * @param isUnique false inside a point instancer, whose prims have no names of their own
     */
    private List<SceneNode> build(int index, Transform world, Transform pending, int groups, int depth, boolean isUnique)
            throws IOException, MeshException {
        if (++visits > 2L * SceneLimits.MAX_SHAPES) {
            throw nodes.problem("must have at most " + SceneLimits.MAX_SHAPES + " objects, with all instances");
        }
        if (!shows[index]) {
            return List.of();
        }
        progress.checkCanceled("canceled while the stage was imported");
        if (depth > MAX_DEPTH) {
            assembler.notes.add("objects nested more than " + MAX_DEPTH + " deep");
            return List.of();
        }
        JsonValue in = nodes.element(index);
        Transform local = pending.times(UsdStage.transform(in.get("matrix")));
        boolean isGroup = groups < MAX_GROUPS;
        List<Placement> placements = isGroup ? TransformDecomposition.decompose(local) : List.of();
        if (isGroup && placements.isEmpty()) {
            assembler.notes.add("objects that are flat, too small or too large");
            return List.of();
        }
        Transform inner = isGroup ? world.times(local) : world;
        Transform rest = isGroup ? Transform.IDENTITY : local;
        String name = in.get("name").text().orElse("");
        String groupName = "";
        List<SceneNode> content = new ArrayList<>();
        boolean isLeaf = isGroup && children.get(index).isEmpty() && !in.get("instances").isPresent() && parts.count(in) == 1
                && !(in.get("solid").isPresent() && in.get("matrices").isPresent());
        if (isLeaf) {
            Transform outer = placements.size() == 1 ? world : world.times(placements.getFirst().transform());
            content.add(parts.shape(in, placements.getLast(), outer));
            placements = placements.subList(0, placements.size() - 1);
        } else {
            groupName = isGroup ? assembler.names.unique(name, "group") : "";
            content.addAll(parts.shapes(in, rest, inner));
        }
        for (int child : children.get(index)) {
            content.addAll(build(child, inner, rest, groups + 1, depth + 1, isUnique));
        }
        content.addAll(instances(in.get("instances"), inner, rest, groups + 1, depth + 1));
        return content.isEmpty() || !isGroup ? content : finish(index, in,
                wrapped(groupName.isEmpty() ? name : groupName, !groupName.isEmpty(), placements, content), local, isUnique);
    }

    /** Wraps nodes in one group for each placement; the outermost has the name, if it is reserved for it. */
    private List<SceneNode> wrapped(String name, boolean isReserved, List<Placement> placements, List<SceneNode> content) {
        List<SceneNode> result = content;
        for (int i = placements.size() - 1; i >= 0; i--) {
            String own = i == 0 && isReserved ? name : assembler.names.unique(name, "group");
            result = List.of(new NodeGroup(own, placements.get(i), result));
        }
        return result;
    }

    /** Adds visibility, path and animation of a finished node. */
    private List<SceneNode> finish(int index, JsonValue in, List<SceneNode> built, Transform local, boolean isUnique)
            throws IOException, MeshException {
        SceneNode node = built.getFirst();
        boolean isHidden = in.get("hidden").bool(false);
        if (isUnique) {
            names.put(index, node.name());
            UsdPaths.addObject(assembler, node.name(), in);
            animate(in, node, local);
        }
        return List.of(isHidden ? node.withVisible(false) : node);
    }

    private void animate(JsonValue in, SceneNode node, Transform local) throws IOException, MeshException {
        Transform[] frames = stage.transforms(in.get("matrices"));
        JsonValue hidden = in.get("hiddenAt");
        int count = Math.max(frames.length, hidden.size());
        if (count == 0) {
            return;
        }
        // The transform above the prim, which is not animated, is what is left of its own.
        Transform above = in.get("parent").integer(PROTOTYPE, nodes.size()) == -1 ? upright : Transform.IDENTITY;
        List<SceneNode> states = new ArrayList<>();
        Placement previous = node.placement();
        for (int i = 0; i < count; i++) {
            SceneNode state = i < hidden.size() ? node.withVisible(!hidden.element(i).bool(false)) : node;
            if (i < frames.length) {
                List<Placement> placements = TransformDecomposition.decompose(above.times(frames[i]));
                if (placements.size() != 1) {
                    assembler.notes.add("animation that shears or flattens objects");
                    return;
                }
                previous = NearestAngles.continued(previous, placements.getFirst());
                state = state.withPlacement(previous);
            }
            states.add(state);
        }
        tracks.addAll(new FrameTracks(firstFrame).of(node, states));
    }

    private List<SceneNode> instances(JsonValue in, Transform world, Transform rest, int groups, int depth)
            throws IOException, MeshException {
        if (!in.isPresent()) {
            return List.of();
        }
        int[] indices = stage.ints(in.get("indices"));
        Transform[] matrices = stage.transforms(in.get("matrices"));
        List<SceneNode> result = new ArrayList<>();
        for (int i = 0; i < Math.min(indices.length, matrices.length); i++) {
            if (indices[i] < 0 || indices[i] >= in.get("prototypes").size()) {
                assembler.notes.add("instances of a missing prototype");
                continue;
            }
            int prototype = in.get("prototypes").element(indices[i]).integer(-1, nodes.size() - 1);
            if (prototype >= 0) {
                result.addAll(build(prototype, world, rest.times(matrices[i]), groups, depth, false));
            }
        }
        return result;
    }
}
