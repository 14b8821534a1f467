package lightning.jen;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.math.Vec3;
import lightning.mesh.Mesh;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.Texture;
import lightning.scene.World;
import lightning.text.Quote;

/** Makes the scene from the blocks of a file and finds what is wrong between blocks. */
final class SceneBuilder {
    private final Tokens tokens;
    private final Problems problems;
    private final TextureFolder textures;
    private final MeshFolder meshes;
    private final Map<String, Block> named = new HashMap<>();
    private final Set<String> materialNames = new LinkedHashSet<>();
    private final Set<String> bankNames = new LinkedHashSet<>();
    /** Banks that lights may belong to though no block says them. */
    private final List<Bank> known;
    private int shapes;

    /** @param folder where files that the scene names are looked for, as if its own were in it */
    SceneBuilder(Tokens tokens, Problems problems, Path folder) {
        this(tokens, problems, folder, List.of());
    }

    /** @param known banks that lights may belong to though no block says them */
    SceneBuilder(Tokens tokens, Problems problems, Path folder, List<Bank> known) {
        this.known = known;
        this.tokens = tokens;
        this.problems = problems;
        textures = new TextureFolder(folder);
        meshes = new MeshFolder(folder);
    }

    /** The scene, or nothing where there are problems. */
    Optional<Scene> build(List<Block> blocks) {
        Optional<Picture> picture = single(blocks, Blocks.PICTURE);
        Optional<Camera> camera = single(blocks, Blocks.CAMERA);
        Optional<World> world = single(blocks, Blocks.WORLD);
        List<Material> materials = materials(of(blocks, Blocks.MATERIAL));
        List<Node> nodes = nodes(blocks.stream().filter(b -> Blocks.NODES.contains(b.type.keyword())).toList(), 1, 1);
        List<Bank> banks = banks(of(blocks, Blocks.BANK));
        List<Light> lights = lights(of(blocks, Blocks.LIGHT));
        return problems.isEmpty()
                ? Optional.of(new Scene(picture.orElse(Picture.DEFAULT), camera.orElse(Camera.DEFAULT),
                        world.orElse(World.DEFAULT), new Stage(materials, nodes), Rig.of(lights, banks)))
                : Optional.empty();
    }

    private static List<Block> of(List<Block> blocks, BlockType<?> type) {
        return blocks.stream().filter(b -> b.type == type).toList();
    }

    private <T> Optional<T> single(List<Block> blocks, BlockType<T> type) {
        List<Block> all = of(blocks, type);
        all.stream().skip(1).forEach(b -> problem(b, b.title() + " must be written once, found it again"));
        return all.isEmpty() ? Optional.empty() : record(all.getFirst(), type, List.of());
    }

    private List<Material> materials(List<Block> blocks) {
        List<Material> materials = new ArrayList<>();
        materialNames.add(Material.DEFAULT.name());
        Map<String, Block> known = new HashMap<>();
        for (Block block : blocks) {
            unique(known, block);
            materialNames.add(block.name);
            record(block, Blocks.MATERIAL, List.of()).ifPresent(materials::add);
        }
        count(blocks, Limits.MAX_MATERIALS, "materials");
        return materials;
    }

    private List<Bank> banks(List<Block> blocks) {
        List<Bank> banks = new ArrayList<>(known);
        known.forEach(bank -> bankNames.add(bank.name()));
        for (Block block : blocks) {
            unique(named, block);
            bankNames.add(block.name);
            record(block, Blocks.BANK, List.of()).ifPresent(banks::add);
        }
        count(blocks, Limits.MAX_BANKS, "banks");
        return banks;
    }

    private List<Light> lights(List<Block> blocks) {
        List<Light> lights = new ArrayList<>();
        for (Block block : blocks) {
            unique(named, block);
            checkNamed(block, "bank", bankNames);
            record(block, Blocks.LIGHT, List.of()).ifPresent(lights::add);
        }
        count(blocks, Limits.MAX_LIGHTS, "lights");
        return lights;
    }

    private void count(List<Block> blocks, int most, String what) {
        if (blocks.size() > most) {
            problem(blocks.get(most), "a scene may have at most " + most + " " + what + ", found " + blocks.size());
        }
    }

    /**
     * @param least the product of the smallest scale factors of the groups around
     * @param most  the product of the largest
     */
    private List<Node> nodes(List<Block> blocks, double least, double most) {
        List<Node> nodes = new ArrayList<>();
        for (Block block : blocks) {
            unique(named, block);
            Placement scale = scale(block);
            double smallest = least * scale.leastScale();
            double largest = most * scale.mostScale();
            try {
                Limits.combinedScale(block::title, smallest, largest);
            } catch (IllegalArgumentException e) {
                problem(block, e.getMessage());
            }
            if (block.type != Blocks.GROUP) {
                checkNamed(block, "material", materialNames);
                if (++shapes == Limits.MAX_SHAPES + 1) {
                    problem(block, "a scene may have at most " + Limits.MAX_SHAPES + " shapes");
                }
            }
            List<Node> children = nodes(block.children, smallest, largest);
            record(block, block.type, children).ifPresent(n -> nodes.add((Node) n));
        }
        return nodes;
    }

    private static Placement scale(Block block) {
        Block.Entry entry = block.entry("scale");
        return entry == null ? Placement.IDENTITY
                : new Placement(Vec3.ZERO, Vec3.ZERO, new Values(Map.of("scale", entry.value()), null).vector("scale"));
    }

    /** @param property says what is named, and is called like it */
    private void checkNamed(Block block, String property, Set<String> names) {
        Block.Entry entry = block.entry(property);
        if (entry != null && entry.value() instanceof Value.Name(String name) && !names.contains(name)) {
            problems.add(tokens.start(entry.from()), block.title() + ": there is no " + property + " " + Quote.of(name)
                    + Nearest.hint(name, names));
        }
    }

    private void unique(Map<String, Block> known, Block block) {
        Block other = block.name.isEmpty() ? null : known.putIfAbsent(block.name, block);
        if (other != null) {
            problem(block, block.title() + ": names must be unique, found a " + other.type.keyword() + " with this name before");
        }
    }

    /** The record of a block; nothing where a problem of the file stands in the way. */
    private <T> Optional<T> record(Block block, BlockType<T> type, List<Node> children) {
        Map<String, Value> values = new HashMap<>(type.initials());
        block.entries().forEach(entry -> values.put(entry.property().name(), entry.value()));
        if (block.entry("repeat") != null && !block.isWritten("texture")) {
            problems.add(tokens.start(block.entry("repeat").nameToken()),
                    block.title() + ": repeat needs a texture, found none");
        }
        Texture image = image(block);
        Mesh mesh = mesh(block);
        if (!problems.isEmpty() && (type.named() && block.name.isEmpty()
                || type.header().filter(p -> !values.containsKey(p.name())).isPresent()
                || (block.isWritten("texture") || block.isWritten(LightAttribute.GOBO.name())) && image == null
                || block.isWritten(Blocks.FILE) && mesh == null)) {
            return Optional.empty();
        }
        try {
            return Optional.of(type.builder().build(block.name, new Values(values, new Loaded(image, mesh)), children));
        } catch (IllegalArgumentException e) {
            problem(block, block.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    /** What names a picture: no block has two such properties. */
    private static Block.Entry picture(Block block) {
        Block.Entry texture = block.entry("texture");
        return texture == null ? block.entry(LightAttribute.GOBO.name()) : texture;
    }

    private Texture image(Block block) {
        Block.Entry entry = picture(block);
        if (entry == null) {
            return null;
        }
        try {
            return textures.load(((Value.Quoted) entry.value()).file());
        } catch (UnusableFileException e) {
            problems.add(tokens.start(entry.from()), block.title() + ": " + e.getMessage());
            return null;
        }
    }

    private Mesh mesh(Block block) {
        Block.Entry file = block.entry(Blocks.FILE);
        if (file == null) {
            return null;
        }
        Block.Entry part = block.entry(Blocks.PART);
        try {
            return meshes.load(((Value.Quoted) file.value()).file(), part == null ? "" : ((Value.Name) part.value()).name());
        } catch (UnusableFileException e) {
            problems.add(tokens.start(file.from()), block.title() + ": " + e.getMessage());
            return null;
        }
    }

    /** What the files of one block hold. */
    private record Loaded(Texture image, Mesh mesh) implements SceneFiles {
        @Override
        public Texture texture(String file) {
            return image;
        }

        @Override
        public Mesh mesh(String file, String part) {
            return mesh;
        }
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.place()), message);
    }
}
